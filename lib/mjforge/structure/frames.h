// Coincidences of frames, by the rule of MuJoCo 3.2 and later.
#pragma once

#include <mujoco/mujoco.h>

namespace mjforge::structure {

/// Values of mjtSameFrame: which frame of its body a frame coincides with.
enum SameFrame { kNone, kBody, kInertia, kBodyRotation, kInertiaRotation };

/// Compares the inertia frame of a body with its frame.
SameFrame SameFrameOfBody(const mjModel& m, int body);
/// Compares the frame of an element of a body with those of the body.
SameFrame SameFrameOf(const mjModel& m, int body, const mjtNum* pos, const mjtNum* quat);

}  // namespace mjforge::structure
