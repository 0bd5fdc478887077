// Broad phase of collision detection: pairs of geoms whose bounding boxes overlap.
#pragma once

#include <utility>
#include <vector>

#include <mujoco/mujoco.h>
#include <Eigen/Dense>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {

/// Finds pairs of geoms near each other by bounding boxes. Replaces MuJoCo's own broad phase,
/// because MuJoCo before 2.3.3 tests each geom of a body against each geom of another body. If
/// works() is false, the boxes cannot find all contacts of the model, and callers must let MuJoCo
/// find the pairs.
class BroadPhase {
 public:
  explicit BroadPhase(const mjModel& m);

  bool works() const { return works_; }

  /// Finds all pairs of geoms that can touch before any body has moved by more than its allowance
  /// relative to the body `frame`. `allowances` has a distance for each body, m. Uses the poses
  /// that mj_kinematics wrote to `d`. The result is valid until the next call.
  engine::GeomPairs& Find(const mjData& d, const std::vector<double>& allowances, int frame);

  /// Finds all contacts at the poses that mj_kinematics and mj_comPos wrote to `d`. `m` must be the
  /// model from which this object was made. Lets MuJoCo find the pairs if works() is false.
  void Collide(mjModel& m, mjData& d);

  /// Ids of the bodies with colliding geoms.
  const std::vector<int>& bodies() const { return bodies_; }
  /// Radius of the sphere about a body's origin that contains the body's colliding geoms, m.
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
  std::vector<Box> local_;       // box of each geom in the geom's frame; empty for planes
  std::vector<Box> boxes_;       // box of each geom in frame F of Find(), with allowance and margin
  std::vector<Box> body_boxes_;  // box around the boxes_ of each body's geoms
  engine::GeomPairs pairs_;
};

}  // namespace mjforge::physics
