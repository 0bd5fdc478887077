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

/// A test of an object with probe bodies. `m` contains the probe bodies, and the test may change
/// `m`.
struct ProbeTest : ModelTest {
  std::span<const mjtNum> start;  // positions of the object's joints, without probe bodies
};

/// Returns an MJCF text to which `bodies` are added at the end of the world, and `equalities` to
/// the section of equalities; both arguments are MJCF elements. Removes keyframes, because they
/// would have too few positions.
std::string WithBodies(std::string_view text, std::string_view bodies,
                       std::string_view equalities = {});

constexpr std::string_view kUsualContact = R"(condim="3" friction="1 0.005 0.0001")";

/// Returns the MJCF of a geom for a probe body. The geom collides with every colliding geom. The
/// geom sets all contact attributes, because defaults of the file would otherwise change them.
/// `shape` has the attributes for type and size, `mass` is in kg, and `contact` has the attributes
/// condim and friction.
std::string ProbeGeom(std::string_view shape, double mass,
                      std::string_view contact = kUsualContact);

/// Sets the positions of the object's joints in `d` to `start`. Leaves the positions of the probe
/// bodies unchanged: `count` numbers of qpos, which begin with that of the joint `first`.
void PlaceObject(const mjModel& m, mjData& d, std::span<const mjtNum> start, int first, int count);

/// Makes a degree of freedom so heavy that nothing moves it.
void HoldDof(mjModel& m, int dof);

/// Makes all degrees of freedom so heavy that nothing moves them, except `count` degrees of freedom
/// from the index `first` on. Disables equalities, limits, springs, dampers and actuators.
void HoldOthers(mjModel& m, int first, int count);

}  // namespace mjforge::physics
