// Checks of a model's behaviour in simulations: drop, stability, resting and driven joints.
#pragma once

#include "mjforge/physics/film_recorder.h"
#include "mjforge/physics/model_under_test.h"

namespace mjforge::physics {

/// Runs the simulations that the spec's `checks` ask for and reports their findings. Fills in all
/// members of `test.result` except `overlap`, `settled`, and those of the tests with probe bodies
/// (`holds`, `fits`, `grasps`). May enlarge the model's buffers for contacts. May throw
/// std::exception.
void CheckBehaviour(const ModelTest& test);

/// Records the drop of the model. If a nudge (an initial tilt and speed) topples the object, also
/// records the drop with that nudge.
void RecordDrop(const ModelTest& test, FilmRecorder& recorder);

}  // namespace mjforge::physics
