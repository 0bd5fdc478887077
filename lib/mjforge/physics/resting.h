#pragma once

#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"

namespace mjforge::physics {

/// A hinge or slide that is not where it should be at the end of a drop.
struct Misplaced {
  int joint = 0;
  double position = 0;  // rad or m, as qpos has it
  double low = 0;       // where it may be
  double high = 0;
  double beyond = 0;                         // how far it is outside of that
  const model::JointCheck* check = nullptr;  // whose `rests` it violates; null: its own range
  double speed = 0;  // rad/s or m/s, if it is still there, but leaves within 10 s; else 0
};

/// Whether an entry of checks.joints says where its joints rest.
bool SaysRests(const model::Checks& checks);

/// Compares where the joints of `d` stand with their ranges, which they may leave by
/// checks.joint_overshoot (or an entry's) of the range and 1 mm or 0.02 rad, and with `rests` of
/// checks.joints, where they must stay for 10 s at their last speed. `object` is its name.
std::vector<Misplaced> MisplacedJoints(const mjModel& m, const mjData& d, std::string_view object,
                                       const model::Checks& checks);

}  // namespace mjforge::physics
