// Comparison of the frames of geoms, sites and inertias with body frames, by the rule of the
// function setSameframe in MuJoCo 4.0 (engine_setconst.c).
#include "mjforge/structure/frames.h"

#include <mujoco/mujoco.h>

#include <cmath>

namespace mjforge::structure {
namespace {

constexpr mjtNum kTolerance = 1e-6;

bool AreEqual(const mjtNum* a, const mjtNum* b, int count, double sign = 1) {
  for (int i = 0; i < count; ++i) {
    if (std::abs(a[i] - sign * b[i]) >= kTolerance) return false;
  }
  return true;
}

constexpr mjtNum kOrigin[3] = {0, 0, 0};
constexpr mjtNum kIdentity[4] = {1, 0, 0, 0};

bool IsSameRotation(const mjtNum* a, const mjtNum* b) {
  return AreEqual(a, b, 4) || AreEqual(a, b, 4, -1);
}

}  // namespace

SameFrame SameFrameOfBody(const mjModel& m, int body) {
  if (!IsSameRotation(m.body_iquat + 4L * body, kIdentity)) return kNone;
  return AreEqual(m.body_ipos + 3L * body, kOrigin, 3) ? kBody : kBodyRotation;
}

SameFrame SameFrameOf(const mjModel& m, int body, const mjtNum* pos, const mjtNum* quat) {
  if (IsSameRotation(quat, kIdentity)) return AreEqual(pos, kOrigin, 3) ? kBody : kBodyRotation;
  if (!IsSameRotation(quat, m.body_iquat + 4L * body)) return kNone;
  return AreEqual(pos, m.body_ipos + 3L * body, 3) ? kInertia : kInertiaRotation;
}

}  // namespace mjforge::structure
