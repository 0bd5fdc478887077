#pragma once

#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {

/// A joint that moves its body into the body's parent. MuJoCo does not let a body collide with its
/// parent, so that nothing stops it.
struct Passing {
  int joint = 0;
  int body = 0;
  int parent = 0;
  double depth = 0;                          // m, beyond that where the joint starts
  double where = 0;                          // rad or m: the joint's position there
  const model::JointCheck* check = nullptr;  // the entry of checks.joints that speaks of it
};

/// Hinges and slides that pass more than `joint_penetration` deep into their parents somewhere in
/// their ranges. Looks at 8 to 40 positions of each, if possible 2 mm apart, all others standing
/// where they start, or where an entry of checks.joints has them. `object` is its name. May throw
/// std::exception.
std::vector<Passing> PassingJoints(const mjModel& m, Workspace& workspace, std::string_view object,
                                   const model::Checks& checks);

}  // namespace mjforge::physics
