// Grasp test: a gripper with two parallel jaws closes on an object, and lifts, shakes or pulls the
// object.
#pragma once

#include "mjforge/physics/probe_bodies.h"

namespace mjforge::physics {

/// Tries grasps at the sites that checks.grasps names. If checks.grasps names none, tries the sites
/// whose names begin with "grasp"; if there are none, opposite faces of the first free body.
/// Reports sites at which no grasp holds the object, and fills in result.grasps. `test.m` must be
/// loaded from a text of WithGripper(). May throw std::exception.
void CheckGrasps(const ProbeTest& test);

}  // namespace mjforge::physics
