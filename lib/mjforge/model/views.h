#pragma once

// Cameras and lights, which are elements of their bodies.

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Moves a camera or light, X_BV, to X_AB * X_BV.
void MoveView(const Pose& X_AB, Element& view);

/// Adds a finding for each that looks at its own body, or at one that the object does not have.
void CheckViews(const Object& object, diag::Findings& findings);

}  // namespace mjforge::model
