// Cameras and lights of bodies.

#pragma once

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Expresses the pose of a camera or light, X_BV, in frame A: X_AB * X_BV.
void MoveView(const Pose& X_AB, Element& view);

/// Adds a finding for each camera or light whose target is its own body or does not exist.
void CheckViews(const Object& object, diag::Findings& findings);

}  // namespace mjforge::model
