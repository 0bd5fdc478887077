// Coincidences of frames, by the rule of MuJoCo 3.2 and later.
#pragma once

struct mjModel_;

namespace mjforge::structure {

/// Values of mjtSameFrame: which frame of its body a frame coincides with.
enum SameFrame { kNone, kBody, kInertia, kBodyRotation, kInertiaRotation };

/// Compares the inertia frame of a body with its frame.
SameFrame SameFrameOfBody(const mjModel_& m, int body);
/// Compares the frame of an element of a body with those of the body. `pos` has 3 numbers,
/// `quat` 4.
SameFrame SameFrameOf(const mjModel_& m, int body, const double* pos, const double* quat);

}  // namespace mjforge::structure
