#include <catch2/catch.hpp>

#include "models.h"

namespace mjforge::picture {
namespace {

TEST_CASE("the geom at a place of the picture is the nearest visible one") {
  const auto subject = Load(
      "<mujoco><worldbody><body name='a'>"
      "<geom name='left' type='sphere' size='0.1' pos='-0.3 0 0'/>"
      "<geom name='right' type='sphere' size='0.1' pos='0.3 0 0'/>"
      "<geom name='behind' type='sphere' size='0.1' pos='0.3 0.3 0'/>"
      "<geom name='hidden' type='sphere' size='0.2' pos='0.3 -0.2 0' group='3'/>"
      "</body></worldbody></mujoco>");
  Options options;
  options.view = {.azimuth = 90, .elevation = 0, .distance = {}};  // x to the right
  CHECK(GeomAt(*subject, options, 0.15, 0.5) == "left");
  CHECK(GeomAt(*subject, options, 0.85, 0.5) == "right");
  CHECK(GeomAt(*subject, options, 0.5, 0.5).empty());
  CHECK(GeomAt(*subject, options, 0.5, 0.01).empty());
}

TEST_CASE("the geom follows the pose of the joints") {
  const auto subject = Load(
      "<mujoco><worldbody><body name='a'><geom name='arm' type='box' size='0.3 0.02 0.02'/>"
      "<joint name='a_turn' axis='0 1 0'/></body></worldbody></mujoco>");
  Options options;
  options.view = {.azimuth = 90, .elevation = 0, .distance = 3};
  CHECK(GeomAt(*subject, options, 0.35, 0.5) == "arm");
  CHECK(GeomAt(*subject, options, 0.5, 0.35).empty());
  diag::Findings findings;
  REQUIRE(subject->SetJoint(*subject->FindJoint("turn", findings), 1.5708, findings));
  CHECK(GeomAt(*subject, options, 0.35, 0.5).empty());
  CHECK(GeomAt(*subject, options, 0.5, 0.35) == "arm");
}

}  // namespace
}  // namespace mjforge::picture
