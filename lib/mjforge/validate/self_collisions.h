// Check for bodies of an object that touch each other.
#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// Adds an error, at the place of the second body, for each pair of bodies whose penetration at the
/// start reaches object.checks.self_collision. Penetration is measured between shapes enlarged by
/// their margins. If no pair touches at the start, and a keyframe contains the start, adds warnings
/// about bodies of one tree that touch in the zero configuration (qpos0). An error does not depend
/// on the form of the start, because a file with its start at qpos0 has no other zero
/// configuration. Bodies of piles may overlap by model::Pile::kMostDepth. Adds a warning instead of
/// an error if both bodies are from one attached file. A body and its parent can touch only if the
/// parent is fixed to the world, because MuJoCo ignores their contacts otherwise. Such a pair adds
/// a warning; if the root has no name, the pair adds no finding, because the model that includes
/// the object lets the root move. Returns true if it adds findings. `m` must be compiled from the
/// object and compared with it; it is unusable afterwards. May throw std::exception.
bool CheckSelfCollision(mjModel& m, const model::Object& object, diag::Findings& findings);

/// Formats the distance of a contact: "1.2 mm deep", "0.5 mm apart, within the margin".
std::string DepthText(double distance);

}  // namespace mjforge::validate
