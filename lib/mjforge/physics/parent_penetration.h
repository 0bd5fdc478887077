// Search for bodies that penetrate their parents, which MuJoCo does not notice, because it ignores
// contacts between parent and child.
#pragma once

#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {

/// Deepest penetration of a body into its parent, at the start or over the range of a joint.
/// Nothing stops the joint, because MuJoCo ignores contacts between parent and child.
struct ParentPenetration {
  int joint = 0;
  int body = 0;
  int parent = 0;
  bool is_added = false;                     // true: `depth` is the increase since the start
  double depth = 0;                          // m
  double where = 0;                          // position of the joint, rad or m, if is_added
  const model::JointCheck* check = nullptr;  // entry of checks.joints that names the joint
};

/// Returns the bodies that penetrate their parents by more than `joint_penetration` at the start,
/// and the joints that increase this depth by more than `joint_penetration`. Tries 8 to 40
/// positions of each joint (of a ball joint, about each axis), 2 mm apart if possible. Other joints
/// are at their start positions, or at those that `at` of an entry of checks.joints sets. `object`
/// is the name of the object. May throw std::exception.
std::vector<ParentPenetration> FindParentPenetrations(const mjModel& m, Workspace& workspace,
                                                      std::string_view object,
                                                      const model::Checks& checks);

}  // namespace mjforge::physics
