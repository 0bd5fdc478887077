// Bodies of an object that touch each other.
#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// Adds an error, at the place of the second body, for each pair of bodies whose penetration (of
/// shapes enlarged by their margins) reaches object.checks.self_collision with all joints at zero.
/// If no pair touches there, checks the start pose. Bodies of piles may overlap by
/// model::Pile::kMostDepth. The error is a warning if both bodies are from one attached file. A
/// body and its parent count as a pair only if MuJoCo lets them collide because the parent is fixed
/// to the world. Such a pair adds a warning, or no finding if the root has no name, because then a
/// host lets the object move. Returns true if it adds findings. `m` must be compiled from the
/// object and compared with it; it is unusable afterwards. May throw std::exception.
bool CheckSelfCollision(mjModel& m, const model::Object& object, diag::Findings& findings);

/// Formats the distance of a contact: "1.2 mm deep", "0.5 mm apart, within the margin".
std::string DepthText(double distance);

}  // namespace mjforge::validate
