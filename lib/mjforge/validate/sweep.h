#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/validate/validate.h"

namespace mjforge::validate {

/// See Sweep in validate.h. The box is in the frame of the body `frame` with all joints at zero; 0
/// means the world. Leaves the model unusable; may throw std::exception.
Sweep SweepModel(mjModel& m, int frame);

}  // namespace mjforge::validate
