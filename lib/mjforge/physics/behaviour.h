// Checks of a model's behaviour in simulations: drop, stability, resting and driven joints.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/physics/film_recorder.h"
#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Runs the simulations that the spec's `checks` ask for and reports their findings. Fills in all
/// members of `result` except the overlap and those of the tests with probe bodies (balls, pegs,
/// grippers). `object` is the object from which the model was made, or that was read from the
/// model. Findings about the whole object point at `mark`. May enlarge the model's buffers for
/// contacts. May throw std::exception.
void CheckBehaviour(mjModel& m, Workspace& workspace, const model::Object& object,
                    diag::SourceMark mark, static_checks::Reporter& reporter, Result& result);

/// Records the drop of the model. If a nudge (an initial tilt and speed) topples the object, also
/// records the drop with that nudge.
void RecordDrop(mjModel& m, Workspace& workspace, const model::Object& object,
                diag::SourceMark mark, static_checks::Reporter& reporter, FilmRecorder& recorder);

}  // namespace mjforge::physics
