// Feet of an object that stands on a floor: some in the air, or all of them gliding.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of a part that is above the floor, by more than 1 mm and less than half of its own height,
/// while a part like it, as large to a tenth, stands on the floor; and of an object that glides off
/// a floor that leans by checks.nudge. `d` has the state at rest of the tree of bodies with this
/// root, with poses and contacts, on a level plane at `height`, m. Findings without a place of
/// their own point at `mark`.
void CheckFeet(const mjModel& m, const mjData& d, int root, double height,
               const model::Object& object, diag::SourceMark mark,
               static_checks::Reporter& reporter);

}  // namespace mjforge::physics
