#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// True if bodies touch. Adds an error for each pair of bodies that are in each other by
/// object.checks.self_collision or more at the joints' zero, at the second of them; a warning, if
/// one attached file has both. A body and its parent never count as a pair: MuJoCo lets them
/// collide if the parent is fixed to the world, which is a warning, unless the root has no name:
/// then it stands for a host, which lets the object move. `m` must be compiled from the object and
/// compared with it; the call leaves it unusable. May throw std::exception.
bool CheckSelfCollision(mjModel& m, const model::Object& object, diag::Findings& findings);

/// "1.2 mm deep", "0.5 mm apart, within the margin".
std::string DepthText(double distance);

}  // namespace mjforge::validate
