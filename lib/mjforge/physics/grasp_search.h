#pragma once

#include <span>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/jaws.h"

namespace mjforge::physics {

/// A place where jaws can close: two faces of one tree of bodies opposite each other, both within
/// the friction cone of the line between them, and room for the jaws around them.
struct Candidate {
  model::Pose X_WJ;  // of the jaws, in the world
  double width = 0;  // m, between the faces
  int body = 0;      // that has the first face
};

/// How far the jaws are open as they come, m.
double OpeningFor(const Candidate& candidate, const model::Grasping& grasping);

/// Looks for places where the jaws can close on an object whose joints are where `start` has
/// them. `m` is a model of WithJaws(). Faces are found by rays from both sides.
class GraspSearch {
 public:
  GraspSearch(const mjModel& m, mjData& d, const Jaws& jaws, std::span<const mjtNum> start,
              const model::Grasping& grasping);

  /// Along lines through a site and beside it, in directions of its frame, faces of what `only`
  /// is: a body, with all that is welded to it, or a root, with all on it. Best ones first, at
  /// most grasping.tries.
  std::vector<Candidate> At(const model::Pose& X_WS, int only) const;

  /// Anywhere in the box of a root body, those near its centre of mass first.
  std::vector<Candidate> On(int root) const;

 private:
  struct Line;
  std::vector<Line> LinesThrough(const Eigen::Vector3d& p_W, const Eigen::Quaterniond& q_WS,
                                 int only) const;
  std::vector<Candidate> Best(std::vector<Line> lines) const;
  double Distance(const Eigen::Vector3d& from, const Eigen::Vector3d& way, int& hit) const;
  bool IsFree(const Candidate& candidate) const;
  bool IsPartOf(int geom, int only) const;

  const mjModel& m_;
  mjData& d_;
  const Jaws& jaws_;
  std::span<const mjtNum> start_;
  const model::Grasping& grasping_;
  std::vector<int> geoms_;  // that jaws can touch
};

}  // namespace mjforge::physics
