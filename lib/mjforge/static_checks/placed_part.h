// Part at a pose, for measuring distances between parts.
#pragma once

#include "mjforge/distance/distance.h"

namespace mjforge::static_checks {

/// Part at a pose; the base class has the part's shape.
struct PlacedPart : distance::PlacedShape {
  PlacedPart(const model::Part* of, const model::Pose& at)
      : distance::PlacedShape(of->shape, at), part(of) {}

  const model::Part* part;
};

}  // namespace mjforge::static_checks
