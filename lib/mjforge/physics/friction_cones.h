// Check for large friction, which makes contacts soft if MuJoCo's friction cones are pyramids.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of the colliding geom with the most sliding friction, if that friction is above 2 and the
/// friction cones are pyramids. The finding points at the geom's part, or at `mark` if the part has
/// no place.
void CheckFrictionCones(const mjModel& m, const model::Object& object, diag::SourceMark mark,
                        static_checks::Reporter& reporter);

}  // namespace mjforge::physics
