// Parts that represent the solid material of a body, with their masses.
#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::static_checks {

/// Copies of the colliding parts of a body, or of all parts if none collides. Each convex piece of
/// a shape has a share of the shape's mass. If only the mass of the whole body is known
/// (`masses_known` is false), each part has a share of that mass, in proportion to its volume.
struct SolidParts {
  std::vector<model::Part> parts;
  bool masses_known = false;
  double mass = 0;  // kg, sum of the parts' masses
};

SolidParts SolidPartsOf(const model::Body& body);

}  // namespace mjforge::static_checks
