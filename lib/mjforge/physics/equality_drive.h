// Test of equality constraints: errors while the joints that they couple are driven.
#pragma once

#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// An equality constraint and its largest error.
struct EqualityDrive {
  int equality = 0;
  Result::Equality measured;
  int driven = 0;  // id of the joint that was driven when the error was largest
  /// Joint of the equality that would have to leave its range while the other joint of the equality
  /// moves through its range; -1: none.
  int outside_joint = -1;
  double outside = 0;        // distance of outside_joint from its range, rad or m
  double outside_error = 0;  // error of the equality if outside_joint stays in its range
  /// True if the equality would be stiffer with joint1 and joint2 exchanged.
  bool is_reversed = false;
};

/// Drives the joints that test active equalities: for an equality of two joints, joint 2, and also
/// joint 1 if the polynomial is linear; for other equalities, each limited joint that the equality
/// couples. Drives joints like DriveJoints(), but with gravity and with the friction, damping and
/// springs of all joints except the driven joint. Only the equalities move the coupled joints.
/// `object` is the name of the object, and `d` the data of the model. May throw std::exception.
std::vector<EqualityDrive> DriveEqualities(const mjModel& m, mjData& d, std::string_view object,
                                           const model::Checks& checks);

}  // namespace mjforge::physics
