// Probe bodies (balls, pegs, a gripper) that are added to an object's world to test the object.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/physics/model_under_test.h"

namespace mjforge::physics {

constexpr std::string_view kProbePrefix = "mjforge-";  // prefix of the names of probe bodies
// Gravity in tests with probe bodies, whatever gravity the object has.
constexpr double kEarthGravity = 9.81;  // m/s^2

/// A test of an object with probe bodies.
/// The model has the probe bodies; the test may change the model.
struct ProbeTest : ModelTest {
  std::span<const mjtNum> start;  // positions of the object's joints, without probe bodies
};

/// Returns an MJCF text with `bodies` added at the end of the world, and `equalities` added; both
/// arguments are MJCF elements. Removes keyframes, because their number of positions would be
/// wrong.
std::string WithBodies(std::string_view text, std::string_view bodies,
                       std::string_view equalities = {});

constexpr std::string_view kUsualContact = R"(condim="3" friction="1 0.005 0.0001")";

/// Returns the MJCF of a geom for a probe body. The geom collides with every colliding geom, and
/// sets all contact attributes, so that the defaults of the file do not change them. `shape` is the
/// geom's type and size, `mass` in kg, `contact` the geom's condim and friction.
std::string ProbeGeom(std::string_view shape, double mass,
                      std::string_view contact = kUsualContact);

/// Sets the positions of the object's joints in `d` to `start`. The `count` positions of the probe
/// bodies, which begin with that of the joint `first`, stay unchanged.
void PlaceObject(const mjModel& m, mjData& d, std::span<const mjtNum> start, int first, int count);

/// Makes a degree of freedom so heavy that nothing moves it.
void HoldDof(mjModel& m, int dof);

/// Makes all degrees of freedom so heavy that nothing moves them, except `count` degrees of freedom
/// from number `first` on. Disables equalities, limits, springs, dampers and actuators.
void HoldOthers(mjModel& m, int first, int count);

}  // namespace mjforge::physics
