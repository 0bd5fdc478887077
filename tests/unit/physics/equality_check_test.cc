// Equalities hold while their joints are driven, or say why they do not.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

/// A screw cap: it turns by four times a full turn and rises by 4 mm in each.
std::string Cap() {
  return R"(<body name="jar"><geom type="cylinder" size="0.02 0.02"/>
    <body name="cap" pos="0 0 0.03">
      <joint name="rise" type="slide" axis="0 0 1" limited="true" range="0 0.016"/>
      <joint name="turn" axis="0 0 1" limited="true" range="0 25.1327" damping="0.001"/>
      <geom type="cylinder" size="0.022 0.005"/>
    </body></body>)";
}

std::string Thread(const std::string& joints, const std::string& ratio,
                   const std::string& more = {}) {
  return "<equality><joint name=\"thread\" " + joints + " polycoef=\"0 " + ratio + " 0 0 0\"" +
         more + "/></equality>";
}

const std::string kRiseFollows = R"(joint1="rise" joint2="turn")";
const std::string kTurnFollows = R"(joint1="turn" joint2="rise")";
const std::string kLead = "0.00063662";  // m/rad

const Result::Equality& OnlyEquality(const Examined& examined) {
  REQUIRE(examined.result);
  REQUIRE(examined.result->equalities.size() == 1);
  return examined.result->equalities.front();
}

const diag::Finding& OnlyFinding(const Examined& examined) {
  CHECK(examined.Codes() == Strings{"error physics/equality-slips"});
  REQUIRE(examined.findings.begin() != examined.findings.end());
  return *examined.findings.begin();
}

}  // namespace

TEST_CASE(
    "a thread holds if the light turn follows the heavy rise, and slips the other way round") {
  const Examined good = Examine(Cap(), Thread(kTurnFollows, "1570.8"));
  CHECK(good.Codes().empty());
  CHECK(OnlyEquality(good).name == "thread");
  CHECK(OnlyEquality(good).share < 0.01);
  const Examined bad = Examine(Cap(), Thread(kRiseFollows, kLead));
  CHECK(OnlyEquality(bad).share > 0.5);
  const diag::Finding& finding = OnlyFinding(bad);
  CHECK(finding.message.find("'thread' slips by") != std::string::npos);
  CHECK(finding.hint.find("joint1: turn, joint2: rise, polycoef: [0, 1571, 0, 0, 0]") !=
        std::string::npos);
}

TEST_CASE("a lead for each turn instead of each radian is told") {
  const Examined bad = Examine(Cap(), Thread(kRiseFollows, "0.004"));
  CHECK(OnlyFinding(bad).hint.find("joint 'rise' would have to go 84.5 mm beyond its range") !=
        std::string::npos);
}

TEST_CASE("an equality that should hold better is told to be harder") {
  model::Checks checks;
  checks.equality_error = 0.0001;
  const Examined bad = Examine(Cap(), Thread(kTurnFollows, "1570.8"), checks);
  CHECK(OnlyFinding(bad).hint.find("bring solimp closer to 1") != std::string::npos);
}

TEST_CASE("equalities are measured if they act, and if a joint that they couple is driven") {
  const auto measured = [](const std::string& equality, const model::Checks& checks = {}) {
    return Examine(Cap(), equality, checks).result->equalities.size();
  };
  CHECK(measured(Thread(kTurnFollows, "1570.8")) == 1);
  CHECK(measured(Thread(kTurnFollows, "1570.8", " active=\"false\"")) == 0);
  CHECK(measured(R"(<equality><joint joint1="turn"/></equality>)") == 0);
  model::Checks checks;
  checks.joints = {{.joints = {"turn", "rise"}, .skip = "glued"}};
  CHECK(measured(Thread(kTurnFollows, "1570.8"), checks) == 0);
}

TEST_CASE("a linkage closes, and its joints without a range need not make a full turn") {
  const auto bar = [](const std::string& end) {
    return R"(<geom type="capsule" size="0.005" fromto="0 0 0 )" + end + R"("/>)";
  };
  const std::string joint = R"(axis="0 1 0" damping="0.01")";
  const std::string links =
      R"(<body name="base"><geom type="box" size="0.12 0.01 0.01"/>
      <body name="crank" pos="-0.1 0.02 0">
        <joint name="a" limited="true" range="-0.5 0.5" )" +
      joint + "/>" + bar("0 0 0.1") + R"(<body name="rod" pos="0 0.015 0.1"><joint name="c" )" +
      joint + "/>" + bar("0.2 0 0") +
      R"(</body></body><body name="rocker" pos="0.1 0.02 0"><joint name="b" )" + joint + "/>" +
      bar("0 0 0.1") + "</body></body>";
  const Examined linkage = Examine(
      links,
      R"(<equality><connect name="pin" body1="rod" body2="rocker" anchor="0.2 0 0"/></equality>
      <contact><exclude body1="rod" body2="rocker"/></contact>)");
  CHECK(linkage.Codes().empty());
  CHECK(OnlyEquality(linkage).error < 0.005);
}

}  // namespace mjforge::physics
