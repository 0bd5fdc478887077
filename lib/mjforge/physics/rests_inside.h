// Bodies that come to rest in each other because their contact is ignored.
#pragma once

#include <span>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of two bodies whose contact is ignored because of `exclude` or their contact bits, and
/// whose penetration at rest exceeds their penetration at the start by more than
/// `joint_penetration`. `rest` has the positions at rest (nq). A body and its parent are left out,
/// because axles overlap their wheels. Findings about bodies without a place point at `mark`. May
/// throw std::exception.
void CheckRestsInside(const mjModel& m, std::span<const mjtNum> rest, Workspace& workspace,
                      const model::Object& object, diag::SourceMark mark,
                      static_checks::Reporter& reporter);

}  // namespace mjforge::physics
