#pragma once

#include <array>
#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// An area cut into convex polygons that share whole sides, as indices of its corners,
/// counter-clockwise: triangles (ear clipping, the shortest cut first), joined where what comes of
/// it is convex, at the longest cuts first. Without holes at most four times as many as there need
/// be. Source: Hertel and Mehlhorn, "Fast triangulation of simple polygons", 1983.
struct Partition {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<int>> convex;
};
Partition PartitionOf(const Area& area);

/// Whether the polygon turns left at each corner, or goes on straight.
bool IsConvex(const std::vector<Point>& corners);

/// Those of a convex polygon at which it goes on straight.
void RemoveStraightCorners(std::vector<Point>& corners);

}  // namespace mjforge::solid
