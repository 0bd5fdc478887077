// Sweep of the joints of a model through their ranges, to find contacts and bounds.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/validate/validate.h"

namespace mjforge::validate {

/// Moves the joints as struct Sweep describes, and returns contacts and bounds. The box is in the
/// frame of the body `frame` (0: the world) at the start. The model is unusable
/// afterwards. May throw std::exception.
Sweep SweepModel(mjModel& m, int frame);

}  // namespace mjforge::validate
