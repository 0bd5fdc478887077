// Errors of equality constraints while the joints that they couple are driven.
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
  int driven = 0;  // the joint that was driven when the error was largest
  /// Joint that the other joint of the equality would move out of its range; -1: none.
  int outside_joint = -1;
  double outside = 0;        // distance of outside_joint from its range, rad or m
  double outside_error = 0;  // error of the equality if outside_joint stays in its range
  /// The equality would be stiff if joint 1 and joint 2 were exchanged.
  bool is_reversed = false;
};

/// Drives each limited joint that an active equality couples, and both joints of an equality of two
/// joints, like DriveJoints(), but with gravity and with the friction of the other joints, which
/// only the equalities move. `object` is the object's name, `d` the model's data. May throw
/// std::exception.
std::vector<EqualityDrive> DriveEqualities(const mjModel& m, mjData& d, std::string_view object,
                                           const model::Checks& checks);

}  // namespace mjforge::physics
