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
  int axis = 0;  // axis of a ball joint, 0 to 2; else 0
  bool limited = false;
  double low = 0;  // ends of the range
  double high = 0;
  double start = 0;  // start position; 0 for a ball joint

  double range() const { return high - low; }
  /// Distance beyond each end to which the joint is pushed to test its limits, rad or m.
  double push = 0;
};

/// Returns the paths of a joint that starts at its position in `qpos` (nq numbers): three paths for
/// a ball joint, none for a free joint or a slide without a range, and one for other joints.
std::vector<JointPath> PathsOf(const mjModel& m, int joint, std::span<const mjtNum> qpos);

/// Returns true if a tendon (-1: none) runs over the joint, or over a site that the joint moves.
bool IsOnTendon(const mjModel& m, int joint, int tendon);

/// Returns a flag for each body of the model: true if the joint moves the body.
std::vector<bool> BodiesMovedBy(const mjModel& m, int joint);

/// Returns groups of joints that can be driven at the same time, because the bodies that one joint
/// of a group moves do not come near the bodies that another joint of the group moves. Ball joints
/// and coupled joints are alone in their groups. `d` has the positions at which the joints start,
/// and the poses that mj_kinematics computes.
std::vector<std::vector<int>> IndependentGroups(const mjModel& m, const mjData& d,
                                                const JointCouplings& couplings,
                                                std::span<const int> joints);

}  // namespace mjforge::physics
