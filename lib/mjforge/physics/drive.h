#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// The outcome of driving one joint.
struct Driven {
  int joint = 0;
  double range = 0;  // rad or m, from end to end
  Result::Joint measured;
  /// The entry of checks.joints that it was driven for; null: none speaks of it.
  const model::JointCheck* check = nullptr;
  /// The bodies that were deepest in each other; empty: none were.
  std::string body1;
  std::string body2;
  double where = 0;    // the joint's value there, rad or m
  double outside = 0;  // how far the start is outside the range, rad or m
  bool blown_up = false;
};

/// Two bodies that are in each other before anything is driven.
struct Jam {
  int body1 = 0;
  int body2 = 0;
  double depth = 0;                          // m
  const model::JointCheck* check = nullptr;  // with whose `at`; null: in the start pose
};

struct Drives {
  std::vector<Driven> joints;
  std::vector<Jam> jams;
};

/// Drives each hinge and slide from where it starts (`compiled::StartOf`) to both ends of its range
/// and back, a ball from its zero, about each of its axes; an unlimited hinge makes a full turn, an
/// unlimited slide has no ends and is left out. A force makes the joint follow smooth moves of half
/// a second; it accounts for the inertia that it has to move, but not for obstacles. Free bodies
/// are held, other joints stay where they start unless something couples them to this one, and
/// there is no gravity, no floor, and no friction, spring or actuator in joints. Joints that cannot
/// get near each other are driven at the same time, and so are those that an entry of
/// checks.joints names together. `object` is its name, `d` the model's data. May
/// throw std::exception.
Drives DriveJoints(const mjModel& m, mjData& d, std::string_view object,
                   const model::Checks& checks);

}  // namespace mjforge::physics
