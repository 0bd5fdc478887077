// Lofts: convex solids between parallel polygons.

#pragma once

#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// A horizontal convex polygon. Coordinates in m.
struct LoftSection {
  std::vector<Point2> corners;  // counter-clockwise
  double z = 0;
};

/// Returns the closed surface, without normals, of the solid between sections with equal numbers of
/// corners, given from bottom to top.
TriangleMesh Loft(const std::vector<LoftSection>& sections);

}  // namespace mjforge::solid
