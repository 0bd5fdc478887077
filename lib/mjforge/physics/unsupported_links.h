// Bodies on hinges and slides with nothing else of their object near them.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of bodies on hinges and slides that start more than 3 cm, or more than a quarter of their
/// own size, from all other bodies of their tree; and of joints that, at an end of their range,
/// have what they move farther than this from all that they do not move: slides, unless they lift
/// it, by more than 3 cm, hinges by more than 3 cm and a quarter of its size. Joints coupled to
/// others and unlimited ones are only looked at where they start. Compares bounding boxes of all
/// geoms, including visual ones. `d` is the model's data at its initial state. Findings without a
/// place of their own point at `mark`.
void CheckUnsupportedLinks(const mjModel& m, mjData& d, const model::Object& object,
                           diag::SourceMark mark, static_checks::Reporter& reporter);

}  // namespace mjforge::physics
