// Value of sameframe for bodies, geoms and sites, by the rule of MuJoCo 3.2 and later.
#pragma once

struct mjModel_;

namespace mjforge::structure {

/// Values of mjtSameFrame. An element's frame equals the frame of its body (kBody) or the inertia
/// frame of its body (kInertia), or only the rotation of one of these frames, or none.
enum SameFrame { kNone, kBody, kInertia, kBodyRotation, kInertiaRotation };

/// Compares the inertia frame of a body with the frame of the body.
SameFrame SameFrameOfBody(const mjModel_& m, int body);
/// Compares the frame of an element (`pos`: 3 numbers, `quat`: 4 numbers, w first, relative to the
/// body) with the frame and the inertia frame of the body.
SameFrame SameFrameOf(const mjModel_& m, int body, const double* pos, const double* quat);

}  // namespace mjforge::structure
