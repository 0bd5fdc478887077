// Grasp test: a gripper with two parallel jaws closes on an object, lifts, shakes or pulls it.
#pragma once

#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Tries the grasps that checks.grasps asks for. Reports sites at which no grasp holds the object,
/// and fills in result.grasps. The model is made from a text of WithGripper(). May throw
/// std::exception.
void CheckGrasps(const ProbeTest& test);

}  // namespace mjforge::physics
