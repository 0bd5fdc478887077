#include <numbers>

#include "mjforge/compiled/compiled.h"

namespace mjforge::compiled {

std::optional<JointRange> RangeOf(const mjModel& m, int joint) {
  const bool limited = m.jnt_limited[joint] != 0;
  const mjtNum* range = m.jnt_range + 2 * static_cast<std::ptrdiff_t>(joint);
  constexpr double kTurn = std::numbers::pi;
  const int type = m.jnt_type[joint];
  if (type == mjJNT_FREE || (type == mjJNT_SLIDE && !limited)) return std::nullopt;
  if (type == mjJNT_BALL) return JointRange{limited, 0, limited ? range[1] : kTurn};
  if (limited) return JointRange{true, range[0], range[1]};
  const double zero = m.qpos0[m.jnt_qposadr[joint]];
  return JointRange{false, zero - kTurn, zero + kTurn};
}

std::array<mjtNum, 4> BallAt(const mjModel& m, int joint, const Eigen::Vector3d& axis,
                             double angle) {
  std::array<mjtNum, 4> turn = {};
  mju_axisAngle2Quat(turn.data(), axis.data(), angle);
  std::array<mjtNum, 4> turned = {};
  mju_mulQuat(turned.data(), m.qpos0 + m.jnt_qposadr[joint], turn.data());
  return turned;
}

}  // namespace mjforge::compiled
