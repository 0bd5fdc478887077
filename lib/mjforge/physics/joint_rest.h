// Joints that rest outside their range, or outside the positions that `rests` of the spec allows.
#pragma once

#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"

namespace mjforge::physics {

/// A hinge or slide outside its range, or outside `rests`, at the end of a drop.
struct JointOffRange {
  int joint = 0;
  double position = 0;  // rad or m, as in qpos
  double low = 0;       // ends of the allowed positions
  double high = 0;
  double beyond = 0;                         // distance from the allowed positions
  const model::JointCheck* check = nullptr;  // entry with the violated `rests`; null: the range
  double speed = 0;  // rad/s or m/s, if the joint is within `rests` but leaves in 10 s; else 0
};

/// Returns true if an entry of checks.joints has `rests`.
bool HasRestRanges(const model::Checks& checks);

/// Compares the joint positions in `d` with their ranges and with `rests` of checks.joints. Joints
/// may exceed their range by checks.joint_overshoot (or an entry's) and by 1 mm or 0.02 rad, and
/// must stay within `rests` for 10 s at their present speed. `object` is the object's name.
std::vector<JointOffRange> FindJointsOffRange(const mjModel& m, const mjData& d,
                                              std::string_view object, const model::Checks& checks);

}  // namespace mjforge::physics
