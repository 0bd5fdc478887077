// Moves the joints of a model through their ranges, and finds contacts and bounds.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/validate/validate.h"

namespace mjforge::validate {

/// Returns the sweep of a model, with the box in the frame of the body `frame` with all joints at
/// zero (0: the world). The model is unusable afterwards. May throw std::exception.
Sweep SweepModel(mjModel& m, int frame);

}  // namespace mjforge::validate
