// Part at a pose, for measuring distances between parts.
#pragma once

#include "mjforge/distance/distance.h"

namespace mjforge::static_checks {

/// A part at a pose in the world. The base class has the part's shape, the pose and the bounding
/// box.
struct PlacedPart : distance::PlacedShape {
  PlacedPart(const model::Part* of, const model::Pose& at)
      : distance::PlacedShape(of->shape, at), part(of) {}

  const model::Part* part;
};

}  // namespace mjforge::static_checks
