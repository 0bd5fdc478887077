#pragma once

#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// A convex polygon at a height.
struct Layer {
  std::vector<Point> corners;  // counter-clockwise
  double z = 0;
};

/// The solid between layers of as many corners, from the lowest to the highest.
Piece StackOf(const std::vector<Layer>& layers);

}  // namespace mjforge::solid
