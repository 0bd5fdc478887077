#pragma once

#include <span>
#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// Closes jaws on the object in the ways that checks.grasps asks for, and says at which sites none
/// of them holds. Fills in result.grasps. `m` is a model of WithJaws(), and is changed; `start` (nq
/// of the object alone) has the positions of its joints. May throw std::exception.
void CheckGrasping(mjModel& m, Workspace& workspace, std::span<const mjtNum> start,
                   const std::string& name, Verdict& verdict, Result& result);

}  // namespace mjforge::physics
