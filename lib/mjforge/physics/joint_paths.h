// Paths on which joints are driven, and groups of joints that can be driven at the same time.
#pragma once

#include <span>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/physics/joint_couplings.h"

namespace mjforge::physics {

/// Motion of one joint about or along one axis. Positions, rad or m, are relative to the model's
/// reference pose (qpos0).
struct JointPath {
  int joint = 0;
  int axis = 0;  // 0 to 2 for a ball joint, else 0
  bool limited = false;
  double low = 0;
  double high = 0;
  double start = 0;  // 0 for a ball joint

  double range() const { return high - low; }
  /// Distance beyond its ends to which the joint is pushed, so that its limits must resist.
  double push = 0;
};

/// Returns the paths of a joint that starts where `qpos` (nq) has it: three of a ball joint, none
/// of a free joint or of a slide without a range.
std::vector<JointPath> PathsOf(const mjModel& m, int joint, std::span<const mjtNum> qpos);

/// Returns true if the joint moves the body; false for a number that is no body's.
bool Moves(const mjModel& m, int joint, int body);

/// Returns true if a tendon (-1: none) runs over the joint, or over a site that the joint moves.
bool IsOnTendon(const mjModel& m, int joint, int tendon);

/// Returns for each of the nbody bodies whether the joint moves it.
std::vector<bool> BodiesMovedBy(const mjModel& m, int joint);

/// Groups joints so that those of a group can be driven at the same time, because bodies moved by
/// one of them do not come near bodies moved by another. `d` has the positions at which the joints
/// start, and results of mj_kinematics.
std::vector<std::vector<int>> IndependentGroups(const mjModel& m, const mjData& d,
                                                const JointCouplings& couplings,
                                                std::span<const int> joints);

}  // namespace mjforge::physics
