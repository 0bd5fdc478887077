#pragma once

#include <utility>
#include <vector>

#include <mujoco/mujoco.h>
#include <Eigen/Dense>

#include "mjforge/engine/engine.h"

namespace mjforge::physics {

/// Finds the pairs of geoms that are near each other, so that MuJoCo need not compare each geom of
/// a body with each of another one. Where it is not possible (`works()`), callers use MuJoCo alone.
class NearPairs {
 public:
  explicit NearPairs(const mjModel& m);

  bool works() const { return works_; }

  /// Bodies are where mj_kinematics left them. Finds all pairs that can touch before any body has
  /// moved by its `allowances` (m), one for each body, in the frame of the body `frame`.
  engine::GeomPairs& Find(const mjData& d, const std::vector<double>& allowances, int frame);

  /// Bodies that have geoms that can collide.
  const std::vector<int>& bodies() const { return bodies_; }
  /// How far such geoms reach from the origin of their body, m.
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
  std::vector<std::vector<int>> geoms_;          // of each body, that can collide
  std::vector<std::pair<int, int>> body_pairs_;  // that may collide, in MuJoCo's order
  std::vector<Box> local_;                       // of each geom, in its frame; of planes empty
  std::vector<Box> boxes_;                       // of each geom, with its allowance and margin
  std::vector<Box> body_boxes_;
  engine::GeomPairs pairs_;
};

/// Steps a model as mj_step does, with the same results, and faster where many geoms are near each
/// other. Bits of geoms must not change as long as it lives. `m` and `d` must outlive it.
class Stepper {
 public:
  Stepper(mjModel& m, mjData& d);

  void Step();

 private:
  /// Where a body is in the frame.
  struct Place {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  };
  /// What a step begins with.
  struct State {
    mjtNum time = 0;
    std::vector<mjtNum> qpos;
    std::vector<mjtNum> qvel;
    std::vector<mjtNum> act;
    std::vector<mjtNum> warmstart;
    std::vector<mjtNum> mocap_quat;
  };

  int FrameOf() const;
  Place PlaceOf(int body) const;
  void Find();
  bool Look();
  void Save();
  void Restore();

  mjModel& m_;
  mjData& d_;
  NearPairs near_;
  int frame_ = 0;  // body
  engine::GeomPairs* pairs_ = nullptr;
  bool is_stale_ = true;            // before the next step
  int steps_ = 0;                   // since pairs were sought
  std::vector<Place> places_;       // of bodies, when pairs were sought
  std::vector<double> allowances_;  // m, of each body
  std::vector<double> moved_;       // m, at the last look
  State state_;
};

}  // namespace mjforge::physics
