#pragma once

// Two parallel jaws that close on an object. Their frame has its origin in the middle between
// them; they close along y, and their fingers point along z.

#include <span>
#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"

namespace mjforge::physics {

/// An MJCF text with the jaws, which do not move as a whole.
std::string WithJaws(std::string_view text, const model::Grasping& grasping);

/// The jaws in a model of such a text.
class Jaws {
 public:
  explicit Jaws(const mjModel& m);

  /// Puts everything at the initial state, the object's joints where `start` has them, and the
  /// jaws at a pose with `opening` (m) between them.
  void Place(mjData& d, std::span<const mjtNum> start, const model::Pose& X_WJ,
             double opening) const;

  /// Lets each of them close with a force, N; below 0 they open.
  void Press(mjData& d, double force) const;

  bool Has(int geom) const;
  /// Whether they touch anything, as mj_collision left it.
  bool Touch(const mjData& d) const;
  /// Whether both of them touch something of the tree of bodies under `root`.
  bool Hold(const mjData& d, int root) const;

 private:
  const mjModel& m_;
  int base_ = 0;      // body
  int joint_ = 0;     // of the first finger; the second one's follows
  double width_ = 0;  // m, when they are open
};

}  // namespace mjforge::physics
