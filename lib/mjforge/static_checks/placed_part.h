// A part at a pose, as distances are measured.
#pragma once

#include "mjforge/distance/distance.h"

namespace mjforge::static_checks {

struct PlacedPart : distance::PlacedShape {
  PlacedPart(const model::Part* of, const model::Pose& at)
      : distance::PlacedShape(of->shape, at), part(of) {}

  const model::Part* part;
};

}  // namespace mjforge::static_checks
