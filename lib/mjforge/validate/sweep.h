#ifndef MJFORGE_VALIDATE_SWEEP_H_
#define MJFORGE_VALIDATE_SWEEP_H_

#include <mujoco/mujoco.h>

#include "mjforge/validate/validate.h"

namespace mjforge::validate {

/// See Sweep in the door. The box is in the frame of the body `frame` at the
/// joints' zero; 0: of the world. Uses the model up; may throw std::exception.
Sweep SweepModel(mjModel& m, int frame);

}  // namespace mjforge::validate

#endif  // MJFORGE_VALIDATE_SWEEP_H_
