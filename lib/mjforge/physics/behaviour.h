#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// Simulates a model and says what is not as it should be. `object` is what the model was made
/// from, or read into; `mark` is for findings of the whole. Fills in all of `result` except the
/// overlap. Changes the model's room for contacts. May throw std::exception.
void CheckBehaviour(mjModel& m, Workspace& workspace, const model::Object& object,
                    diag::SourceMark mark, Verdict& verdict, Result& result);

}  // namespace mjforge::physics
