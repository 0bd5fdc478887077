// Sweep of the joints of a model through their ranges, to find contacts and bounds.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/validate/validate.h"

namespace mjforge::validate {

/// Returns the sweep of a model. The sweep's box is in the frame that the body `frame` (0: the
/// world) has with all joints at zero. The model is unusable afterwards. May throw std::exception.
Sweep SweepModel(mjModel& m, int frame);

}  // namespace mjforge::validate
