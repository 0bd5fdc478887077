// Joints that rest outside their range, or outside the positions that `rests` of the spec allows.
#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Returns true if an entry of checks.joints has `rests`.
bool HasRestRanges(const model::Checks& checks);

/// Returns a remedy if a joint creeps although its dry friction is larger than its load; an empty
/// text if the joint does not creep. `d` has the forces of the last step.
std::string CreepRemedy(const mjModel& m, const mjData& d, int joint);

/// Reports joints whose positions in `d` are beyond their ranges, or outside `rests` of
/// checks.joints. Joints may exceed their range by the share `joint_overshoot` plus 1 mm or 0.02
/// rad, and must stay within `rests` for 10 s at their present speed. Findings about joints without
/// a place point at `mark`.
void CheckJointRests(const mjModel& m, const mjData& d, const model::Object& object,
                     diag::SourceMark mark, static_checks::Reporter& reporter);

}  // namespace mjforge::physics
