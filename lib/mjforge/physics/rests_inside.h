// Bodies that come to rest in each other because their contact is ignored.
#pragma once

#include <span>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Warns of two bodies whose contact is ignored, by `exclude` or by their contact bits, and that
/// are in each other at rest by more than `joint_penetration` deeper than at the start. `rest` has
/// the positions at rest (nq). A body and its parent are left out: joints of axles overlap.
/// Findings without a place of their own point at `mark`. May throw std::exception.
void CheckRestsInside(const mjModel& m, std::span<const mjtNum> rest, Workspace& workspace,
                      const model::Object& object, diag::SourceMark mark,
                      static_checks::Reporter& reporter);

}  // namespace mjforge::physics
