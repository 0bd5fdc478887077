// Cameras and lights of bodies.

#pragma once

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Expresses the pose of a camera or light, X_BV, in frame A: X_AB * X_BV.
void MoveView(const model::Pose& X_AB, model::Element& view);

/// Adds a finding for each camera or light whose target is its own body or does not exist.
void CheckViews(const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::assemble
