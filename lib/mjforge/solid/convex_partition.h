// Convex partition of a polygon with holes: hole bridging, ear clipping, merging.

#pragma once

#include <array>
#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// Triangulation and convex partition of an area. A polygon is a list of indices of the area's
/// corners, counter-clockwise; neighbouring polygons share whole sides. Ear clipping makes the
/// shortest cut first. Merging removes the longest cuts first, each only if the merged polygon is
/// convex. Without holes the partition has at most four times the minimum number of polygons.
/// Source: Hertel and Mehlhorn, "Fast triangulation of simple polygons", 1983.
struct ConvexPartition {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<int>> convex;
};
ConvexPartition PartitionOf(const Area& area);

/// Returns the polygons of ConvexPartition::convex without straight corners.
std::vector<std::vector<Point2>> MergedPolygonsOf(const Area& area);

/// Returns a partition of an area into convex polygons, counter-clockwise. If all sides of the area
/// are parallel to the axes, the polygons are rectangles in rows, from below; otherwise they
/// are those of MergedPolygonsOf().
std::vector<std::vector<Point2>> ConvexPolygonsOf(const Area& area);

/// Sine of the largest angle between two sides of a polygon that counts as straight.
inline constexpr double kStraight = 1e-12;

/// Returns true if an outline that does not cross itself turns left or is straight at each corner.
bool IsConvex(const std::vector<Point2>& corners);

/// Removes the straight corners of a convex polygon.
void RemoveStraightCorners(std::vector<Point2>& corners);

}  // namespace mjforge::solid
