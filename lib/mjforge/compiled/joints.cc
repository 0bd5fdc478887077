// Reads ranges and start positions of joints from compiled models.
#include <algorithm>
#include <numbers>
#include <string>

#include "mjforge/compiled/compiled.h"

namespace mjforge::compiled {

bool HasOneNumber(const mjModel& m, int joint) {
  return m.jnt_type[joint] == mjJNT_HINGE || m.jnt_type[joint] == mjJNT_SLIDE;
}

int SubtreeEnd(const mjModel& m, int body) {
  int end = body + 1;
  while (end < m.nbody && m.body_parentid[end] >= body) ++end;
  return end;
}

bool Moves(const mjModel& m, int joint, int body) {
  const int first = m.jnt_bodyid[joint];
  return body >= first && body < SubtreeEnd(m, first);
}

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

namespace {

// Returns the id of the keyframe NAME_start, which mjforge writes; -1 if the model has none.
int StartKey(const mjModel& m) {
  const std::string name = std::string(m.names) + "_start";  // `names` begins with the model's name
  return mj_name2id(&m, mjOBJ_KEY, name.c_str());
}

}  // namespace

std::span<const mjtNum> StartOf(const mjModel& m) {
  const int key = StartKey(m);
  const auto count = static_cast<std::size_t>(m.nq);
  return key < 0 ? std::span(m.qpos0, count) : std::span(m.key_qpos + key * m.nq, count);
}

void CopyStart(const mjModel& m, mjData& d) {
  const int key = StartKey(m);
  std::ranges::copy(StartOf(m), d.qpos);
  if (key < 0) return;
  std::copy_n(m.key_qvel + key * m.nv, m.nv, d.qvel);
  std::copy_n(m.key_act + key * m.na, m.na, d.act);
  std::copy_n(m.key_ctrl + key * m.nu, m.nu, d.ctrl);
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
