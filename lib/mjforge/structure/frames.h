// Comparison of frames with body frames (sameframe), by the rule of MuJoCo 3.2 and later.
#pragma once

struct mjModel_;

namespace mjforge::structure {

/// Values of mjtSameFrame: the frame of the body that an element's frame, or its rotation, equals.
enum SameFrame { kNone, kBody, kInertia, kBodyRotation, kInertiaRotation };

/// Compares the inertia frame of a body with the body frame.
SameFrame SameFrameOfBody(const mjModel_& m, int body);
/// Compares the frame of an element of a body with the body frame and the inertia frame. `pos` has
/// 3 numbers, `quat` 4.
SameFrame SameFrameOf(const mjModel_& m, int body, const double* pos, const double* quat);

}  // namespace mjforge::structure
