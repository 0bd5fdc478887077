// Parts that make up the mass of a body.
#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::static_checks {

/// The colliding parts of a body, or all parts if none collides. If only the mass of the whole body
/// is known (`masses_known` is false), each part has a share of that mass, in proportion to the
/// part's volume.
struct SolidParts {
  std::vector<model::Part> parts;
  bool masses_known = false;
  double mass = 0;  // kg, sum of the parts' masses
};

SolidParts SolidPartsOf(const model::Body& body);

}  // namespace mjforge::static_checks
