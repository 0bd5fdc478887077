// Checks of how a model behaves in simulations: drop, stability, joints that rest and are driven.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/physics/film_recorder.h"
#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Simulates a model, reports what violates its checks, and fills in `result` except the overlap
/// and the tests with probe bodies. `object` is the object from which the model was made, or which
/// was read from it. Findings about the whole object point at `mark`. May change the model's room
/// for contacts. May throw std::exception.
void CheckBehaviour(mjModel& m, Workspace& workspace, const model::Object& object,
                    diag::SourceMark mark, static_checks::Reporter& reporter, Result& result);

/// Records the drop of these checks, with the nudge that topples the object, if there is one.
void RecordDrop(mjModel& m, Workspace& workspace, const model::Object& object,
                diag::SourceMark mark, static_checks::Reporter& reporter, FilmRecorder& recorder);

}  // namespace mjforge::physics
