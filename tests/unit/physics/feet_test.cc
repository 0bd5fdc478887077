// Feet in the air, and feet that glide.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

/// A table on four legs, one of which is this much shorter; `attributes` are those of all legs.
std::string Table(double shorter, const std::string& attributes = {}) {
  std::string legs = R"(<geom type="box" size="0.4 0.4 0.02" pos="0 0 0.42"/>)";
  for (int i = 0; i < 4; ++i) {
    const double height = i == 3 ? 0.4 - shorter : 0.4;
    legs += "<geom name=\"leg_" + std::to_string(i) + R"(" type="cylinder" size="0.02 )" +
            std::to_string(height / 2) + "\" pos=\"" + (i % 2 == 0 ? "0.35 " : "-0.35 ") +
            (i < 2 ? "0.35 " : "-0.35 ") + std::to_string(0.4 - height / 2) + "\" " + attributes +
            "/>";
  }
  return Free(0, legs);
}

Strings Feet(const std::string& world, bool stable = true) {
  model::Checks checks;
  checks.stable = stable;
  Strings messages;
  for (const diag::Finding& finding : Examine(world, {}, checks).findings)
    if (finding.code == diag::Code::kPhysicsFeet) messages.push_back(finding.message);
  return messages;
}

}  // namespace

TEST_CASE("a leg that is shorter than the others is in the air, if the object must be stable") {
  CHECK(Feet(Table(0)).empty());
  CHECK(Feet(Table(0.0005)).empty());
  CHECK(Feet(Table(0.02), false).empty());
  const Strings messages = Feet(Table(0.02));
  REQUIRE(messages.size() == 1);
  INFO(messages[0]);
  CHECK(messages[0].find(" above the floor where 'm' rests, which must be stable; part 'leg_") !=
        messages[0].npos);
  CHECK(messages[0].ends_with("which is like it, stands on the floor"));
}

TEST_CASE("a part unlike the feet may be near the floor") {
  const std::string handle = R"(<geom type="capsule" size="0.01 0.03" pos="0.08 0 0.045"/></body>)";
  std::string mug = Free(0, R"(<geom type="cylinder" size="0.04 0.05" pos="0 0 0.05"/>)");
  mug.replace(mug.rfind("</body>"), 7, handle);
  CHECK(Feet(mug).empty());
}

TEST_CASE("like parts of which as many are in the air are no feet") {
  // A runner of balls, as of a rocking chair; blades of scissors lie on each other.
  std::string balls;
  for (int i = -3; i <= 3; ++i)
    balls += R"(<geom type="sphere" size="0.02" pos=")" + std::to_string(0.04 * i) + " -0.05 " +
             std::to_string(0.003 * i * i + 0.02) + R"("/><geom type="sphere" size="0.02" pos=")" +
             std::to_string(0.04 * i) + " 0.05 " + std::to_string(0.003 * i * i + 0.02) + "\"/>";
  CHECK(Feet(Free(0, balls)).empty());
  CHECK(Feet(Free(0, R"(<geom type="box" size="0.1 0.02 0.002" pos="0 0 0.002"/>
    <geom type="box" size="0.1 0.02 0.002" pos="0 0 0.0058"/>)"))
            .empty());
}

TEST_CASE("feet with too little friction of their own glide") {
  CHECK(Feet(Table(0, R"(friction="0.05")")).empty());  // the floor has more
  CHECK(Feet(Table(0, R"(friction="0.3" priority="1")")).empty());
  CHECK(Feet(Table(0, R"(friction="0.05" priority="1")")) ==
        Strings{"'m', which must be stable, glides off a floor that leans by 10 deg: the "
                "friction of its feet is 0.05, and must be 0.176"});
}

TEST_CASE("no friction is asked for that a floor does not give") {
  model::Checks checks;
  checks.stable = true;
  checks.nudge = 0.9;
  for (const diag::Finding& finding : Examine(Table(0), {}, checks).findings)
    CHECK(finding.code != diag::Code::kPhysicsFeet);
}

}  // namespace mjforge::physics
