// Simulations of a model: drop, stability, joints at rest, and driven joints.
#pragma once

#include "mjforge/physics/film_recorder.h"
#include "mjforge/physics/model_under_test.h"

namespace mjforge::physics {

/// Runs the simulations that the spec's `checks` request, and reports values beyond the limits of
/// the checks. Fills in all members of `test.result` except `overlap`, `settled`, and those of the
/// tests with probe bodies (`holds`, `fits`, `grasps`). May enlarge the model's buffers for
/// contacts. May throw std::exception.
void CheckBehaviour(const ModelTest& test);

/// Records the drop of the model. If checks.stable is set and a nudge (an initial tilt and speed)
/// topples the object, also records the drop with this nudge.
void RecordDrop(const ModelTest& test, FilmRecorder& recorder);

}  // namespace mjforge::physics
