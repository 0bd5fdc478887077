// Search for grasps: pairs of opposite faces on which a gripper can close.
#pragma once

#include <span>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/gripper.h"

namespace mjforge::physics {

/// Pose of the gripper for a grasp of two opposite faces of one tree of bodies. The line between
/// the faces is inside the friction cones of both faces, and the open gripper touches nothing.
struct GraspCandidate {
  model::Pose X_WJ;  // pose of the gripper in the world
  double width = 0;  // m, distance between the faces
  int body = 0;      // id of the body with the face on the gripper's +y side
};

/// Returns the distance between the jaws before the gripper closes, m.
double OpeningFor(const GraspCandidate& candidate, const model::GraspingCheck& grasping);

/// Finds grasps of an object whose joints are at `start`, by rays that are cast from both sides.
/// `m` must be loaded from a text of WithGripper(), and `d` must be the data of `m`.
class GraspSearch {
 public:
  GraspSearch(const mjModel& m, mjData& d, const Gripper& gripper, std::span<const mjtNum> start,
              const model::GraspingCheck& grasping);

  /// Returns at most grasping.tries grasps, the best first. Tries lines through a site and through
  /// points beside the site, in 13 directions of the site's frame. If `body` is a root, the two
  /// faces of a grasp belong to bodies of its tree; otherwise to `body` or to bodies welded to it.
  std::vector<GraspCandidate> AtSite(const model::Pose& X_WS, int body) const;

  /// Returns at most grasping.tries grasps in the bounding box of a root body's tree, the best
  /// first. Grasps near the centre of mass are preferred.
  std::vector<GraspCandidate> Anywhere(int root) const;

 private:
  struct FaceLine;
  std::vector<FaceLine> LinesThrough(const Eigen::Vector3d& p_W, const Eigen::Quaterniond& q_WS,
                                     int owner) const;
  std::vector<GraspCandidate> Best(std::vector<FaceLine> lines) const;
  double Distance(const Eigen::Vector3d& from, const Eigen::Vector3d& way, int& hit) const;
  bool IsFree(const GraspCandidate& candidate) const;
  bool IsPartOf(int geom, int owner) const;

  const mjModel& m_;
  mjData& d_;
  const Gripper& gripper_;
  std::span<const mjtNum> start_;
  const model::GraspingCheck& grasping_;
  std::vector<int> geoms_;  // colliding geoms of the object
};

}  // namespace mjforge::physics
