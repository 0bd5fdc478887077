// Check of an object's feet on a floor: feet in the air, and feet that slide on a slope.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of a part that is above the floor by more than 1 mm and less than half of its own height,
/// while similar parts (sizes differ by at most a tenth) stand on the floor. Warns of an object
/// that would slide on a floor with a slope of checks.nudge. `d` has the state at rest of the tree
/// of bodies with this root, with poses and contacts, on a level plane at `height`, m. Findings
/// about parts without a place point at `mark`.
void CheckFeet(const mjModel& m, const mjData& d, int root, double height,
               const model::Object& object, diag::SourceMark mark,
               static_checks::Reporter& reporter);

}  // namespace mjforge::physics
