// Check for bodies on hinges and slides that are far from all other bodies of their tree.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of bodies on hinges and slides that start more than 3 cm, or more than a quarter of their
/// own size, from all other bodies of their tree. Warns of joints that, at an end of their range,
/// move their bodies away from the rest of the tree: a slide by more than 3 cm, unless it lifts the
/// bodies; a hinge by more than 3 cm and a quarter of the bodies' size. Coupled and unlimited
/// joints are checked only at the start. Compares bounding boxes of all geoms, including visual
/// geoms. `d` is the model's data at its initial state. Findings about joints without a place point
/// at `mark`.
void CheckUnsupportedLinks(const mjModel& m, mjData& d, const model::Object& object,
                           diag::SourceMark mark, static_checks::Reporter& reporter);

}  // namespace mjforge::physics
