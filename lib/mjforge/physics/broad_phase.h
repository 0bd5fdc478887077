// Broad phase of collision detection: pairs of geoms whose bounding boxes overlap.
#pragma once

#include <utility>
#include <vector>

#include <mujoco/mujoco.h>
#include <Eigen/Dense>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {

/// Finds the pairs of geoms that are near each other, because MuJoCo before 2.3.3 compares each
/// geom of a body with each geom of another. If works() is false, callers must let MuJoCo find all
/// pairs.
class BroadPhase {
 public:
  explicit BroadPhase(const mjModel& m);

  bool works() const { return works_; }

  /// Finds all pairs of geoms that can touch before any body has moved by more than its allowance
  /// (m, one for each body) relative to the body `frame`. Bodies are at the positions that
  /// mj_kinematics computed.
  engine::GeomPairs& Find(const mjData& d, const std::vector<double>& allowances, int frame);

  /// Bodies with colliding geoms.
  const std::vector<int>& bodies() const { return bodies_; }
  /// Radius of the colliding geoms of a body about the body's origin, m.
  double Reach(int body) const { return reaches_[static_cast<std::size_t>(body)]; }

 private:
  using Box = Eigen::AlignedBox3d;
  bool IsCovered(const mjModel& m) const;
  void ListBodies();
  bool MayCollide(int body1, int body2) const;
  void FindBetween(int body1, int body2);

  const mjModel& m_;
  bool works_ = false;
  std::vector<int> bodies_;
  std::vector<double> reaches_;
  std::vector<std::vector<int>> geoms_;          // colliding geoms of each body
  std::vector<std::pair<int, int>> body_pairs_;  // pairs that may collide, in MuJoCo's order
  std::vector<Box> local_;                       // box of each geom in its frame; planes: empty
  std::vector<Box> boxes_;       // box of each geom in `frame`, with allowance and margin
  std::vector<Box> body_boxes_;  // box around the boxes_ of each body's geoms
  engine::GeomPairs pairs_;
};

}  // namespace mjforge::physics
