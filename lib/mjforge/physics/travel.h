#pragma once

#include <span>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/coupling.h"

namespace mjforge::physics {

/// One joint moved along one of its axes. Positions, rad or m, are counted from the joint's place
/// in the model's own pose.
struct Path {
  int joint = 0;
  int axis = 0;  // 1, 2 of a ball
  bool limited = false;
  double low = 0;
  double high = 0;
  double start = 0;  // a ball is driven from the model's own pose

  double range() const { return high - low; }
  /// How far beyond its ends it is pushed, so that the limits have to hold.
  double push = 0;
};

/// The ways of a joint that starts where `qpos` (nq) has it: of a ball about each axis; of a free
/// joint and of a slide without a range none.
std::vector<Path> PathsOf(const mjModel& m, int joint, std::span<const mjtNum> qpos);

/// Which bodies move with a joint, nbody answers.
std::vector<bool> MovedBy(const mjModel& m, int joint);

/// Puts joints into groups, each of which can be driven at once: nothing that one of them moves
/// comes near what another moves. `d` has the model as mj_kinematics left it where the joints
/// start.
std::vector<std::vector<int>> GroupsOf(const mjModel& m, const mjData& d,
                                       const Couplings& couplings, std::span<const int> joints);

}  // namespace mjforge::physics
