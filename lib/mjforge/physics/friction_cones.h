// Friction that makes contacts with pyramidal cones soft.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of the colliding geom with the most sliding friction, if it is above 2 and the friction
/// cones are pyramids. A finding without a place of its own points at `mark`.
void CheckFrictionCones(const mjModel& m, const model::Object& object, diag::SourceMark mark,
                        static_checks::Reporter& reporter);

}  // namespace mjforge::physics
