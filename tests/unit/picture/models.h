#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// A box with a lid on a hinge; the colliding geoms are not the visible ones.
inline const std::string kChest =
    "<mujoco><worldbody><body name='chest' pos='0 0 0.1'><freejoint name='chest_free'/>"
    "<geom size='0.1 0.2 0.1' type='box' group='3'/>"
    "<geom size='0.1 0.2 0.1' type='box' rgba='0.7 0.4 0.2 1' group='2' contype='0' "
    "conaffinity='0' mass='0'/>"
    "<body name='lid' pos='-0.1 0 0.1'>"
    "<joint name='chest_lid_hinge' axis='0 -1 0' range='0 100' limited='true'/>"
    "<geom size='0.1 0.2 0.01' pos='0.1 0 0.01' type='box' rgba='0.2 0.3 0.8 1'/>"
    "</body></body></worldbody></mujoco>";

inline std::unique_ptr<Subject> Load(const std::string& mjcf) {
  std::string why_not;
  auto subject = Loader().LoadText(mjcf, {}, why_not);
  INFO(why_not);
  REQUIRE(subject != nullptr);
  return subject;
}

/// A model of a geom that can move.
inline std::unique_ptr<Subject> LoadGeom(const std::string& attributes) {
  return Load(
      "<mujoco><worldbody><body><freejoint/><inertial pos='0 0 0' mass='1' "
      "diaginertia='1 1 1'/><geom " +
      attributes + "/></body></worldbody></mujoco>");
}

inline std::unique_ptr<Renderer> OpenRenderer() {
  diag::Findings findings;
  auto renderer = Renderer::Open(findings);
  REQUIRE(renderer != nullptr);
  return renderer;
}

}  // namespace mjforge::picture
