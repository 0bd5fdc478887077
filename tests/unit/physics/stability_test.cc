// Tests of stability margins, and of nudges of resting objects.
#include <cmath>
#include <numbers>

#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

constexpr double kDegree = std::numbers::pi / 180;

model::Checks Stable(double nudge = 10 * kDegree) {
  model::Checks checks;
  checks.stable = true;
  checks.nudge = nudge;
  return checks;
}

std::string Pillar(double half_side, double half_height) {
  return Free(0.2, "<geom type=\"box\" size=\"" + std::to_string(half_side) + " " +
                       std::to_string(half_side) + " " + std::to_string(half_height) + "\"/>");
}

}  // namespace

TEST_CASE("how far a pillar can be tilted follows from its half side and half height") {
  const Examined pillar = Examine(Pillar(0.02, 0.1));
  REQUIRE(pillar.result);
  REQUIRE(pillar.result->stability);
  const double angle = std::atan(0.02 / 0.1);
  const double mass = 1000 * 0.04 * 0.04 * 0.2;
  CHECK(pillar.result->stability->angle == Approx(angle).margin(0.5 * kDegree));
  CHECK(pillar.result->stability->energy ==
        Approx(mass * 9.81 * (std::hypot(0.02, 0.1) - 0.1)).epsilon(0.02));
}

TEST_CASE("a ball, and what stands on a point, have no stability") {
  for (const char* geom :
       {R"(<geom size="0.05"/>)", R"(<geom type="capsule" size="0.01 0.04"/>)"}) {
    const Examined object = Examine(Free(0.2, geom));
    REQUIRE(object.result);
    REQUIRE(object.result->stability);
    CHECK(object.result->stability->angle == 0);
    CHECK(object.result->stability->energy == 0);
  }
}

TEST_CASE("what lies in soft contacts, deeper at one end, is not less stable for it") {
  const char* bar =
      R"(<geom type="box" size="0.0891697 0.006 0.003" density="7850"/>)"
      R"(<geom type="cylinder" size="0.014 0.005" pos="0.1021697 0 0" density="7850"/>)";
  const Examined object = Examine(Free(0.2, bar));
  REQUIRE(object.result);
  REQUIRE(object.result->sink > 1e-4);
  REQUIRE(object.result->stability);
  CHECK(object.result->stability->angle > 60 * kDegree);
}

TEST_CASE("what stands upright only undisturbed is not stable") {
  // A disc on a stick on a ball, a capsule on its end, and a thin pillar; all balance if they are
  // not disturbed.
  const std::string top = R"(<geom size="0.002" pos="0 0 0.002"/>)"
                          R"(<geom type="cylinder" size="0.002 0.048" pos="0 0 0.05"/>)"
                          R"(<geom type="cylinder" size="0.04 0.002" pos="0 0 0.098"/>)";
  for (const std::string& world :
       {Free(0, top), Free(0.2, R"(<geom type="capsule" size="0.01 0.04"/>)"), Pillar(0.01, 0.1)}) {
    INFO(world);
    CHECK(Examine(world).result->tilt < 5 * kDegree);
    CHECK(Examine(world, {}, Stable()).Codes() == Strings{"error physics/topples"});
  }
}

TEST_CASE("what comes back when it is nudged is stable, up to what is asked") {
  CHECK(Examine(Pillar(0.03, 0.1), {}, Stable()).Codes().empty());
  CHECK(Examine(Pillar(0.03, 0.1), {}, Stable(25 * kDegree)).Codes() ==
        Strings{"error physics/topples"});
  CHECK(Examine(Pillar(0.01, 0.1), {}, Stable(1 * kDegree)).Codes().empty());
}

TEST_CASE("what balances where it is let go has not come back") {
  for (const double degrees : {9.6, 9.8, 9.9}) {
    INFO(degrees);
    const double side = 0.5 * std::tan(degrees * kDegree);
    const std::string post = "<geom type=\"cylinder\" size=\"" + std::to_string(side) + " 0.5\"/>";
    CHECK(Examine(Free(0.51, post), {}, Stable()).Codes() == Strings{"error physics/topples"});
  }
}

TEST_CASE("what is fixed, or lies among others, is not nudged") {
  const std::string fixed = "<body name=\"fixed\"><geom size=\"0.05\"/></body>";
  CHECK_FALSE(Examine(fixed, {}, Stable()).result->stability);
  const std::string other = "<body pos=\"1 0 0.3\"><freejoint/><geom size=\"0.05\"/></body>";
  CHECK_FALSE(Examine(Pillar(0.03, 0.1) + other, {}, Stable()).result->stability);
}

}  // namespace mjforge::physics
