// Gripper with two parallel jaws. The origin of its frame is the midpoint between the jaws; the
// jaws close along y, and the fingers point along z.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"

namespace mjforge::physics {

/// Returns the MJCF text of an object to which a gripper is added. The palm of the gripper is a
/// mocap body.
std::string WithGripper(std::string_view text, const model::GraspingCheck& grasping);

/// Gripper in a model that was loaded from a text of WithGripper().
class Gripper {
 public:
  explicit Gripper(const mjModel& m);

  /// Resets the data, sets the positions of the object's joints to `start`, and places the gripper
  /// at the pose `X_WJ` with the distance `opening`, m, between the jaws.
  void Place(mjData& d, std::span<const mjtNum> start, const model::Pose& X_WJ,
             double opening) const;

  /// Applies a closing force to each jaw, N; a negative force opens the jaws.
  void Press(mjData& d, double force) const;

  /// Returns true if a geom belongs to the gripper.
  bool Has(int geom) const;
  /// Returns true if a contact in `d` shows that the gripper penetrates another body.
  bool Touches(const mjData& d) const;
  /// Returns true if, by the contacts in `d`, each jaw touches a body of the tree with this root.
  bool Holds(const mjData& d, int root) const;

 private:
  const mjModel& m_;
  int base_ = 0;      // id of the palm's body; the ids of the two fingers follow
  int joint_ = 0;     // id of the first finger's joint; the second finger's id follows
  double width_ = 0;  // m, largest opening
};

}  // namespace mjforge::physics
