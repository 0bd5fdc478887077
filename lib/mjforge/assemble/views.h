// Poses of cameras and lights, and the check of the bodies at which they look.

#pragma once

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Replaces the pose X_BV of a camera or light by its pose in frame A, X_AB * X_BV.
void MoveView(const model::Pose& X_AB, model::Element& view);

/// Adds a finding for each camera or light whose target is its own body or does not exist.
void CheckViews(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
