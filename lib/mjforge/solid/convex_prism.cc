// Extrusion of a convex polygon: removes repeated and straight corners, rejects other polygons.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/solid/convex_partition.h"
#include "mjforge/solid/loft.h"

namespace mjforge::solid {
namespace {

void RemoveRepeatedCorners(std::vector<Point2>& corners) {
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
}

bool HasArea(const std::vector<Point2>& corners) {
  double size = 0;
  for (const Point2& p : corners) size = std::max(size, (p - corners[0]).squaredNorm());
  return std::abs(AreaOf(corners)) > kStraight * size;
}

/// Returns true if a polygon, counter-clockwise, turns left or is straight at each corner and makes
/// a single turn altogether; a pentagram turns left everywhere, but makes two turns.
bool IsConvexLoop(const std::vector<Point2>& corners) {
  double turned = 0;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point2 in = corners[i] - corners[(i + count - 1) % count];
    const Point2 out = corners[(i + 1) % count] - corners[i];
    const double sine = Cross(in, out) / (in.norm() * out.norm());
    if (sine < -kStraight || (sine <= kStraight && in.dot(out) < 0)) return false;
    turned += std::atan2(Cross(in, out), in.dot(out));
  }
  return turned <= 2 * std::numbers::pi + 1e-6;
}

}  // namespace

std::optional<TriangleMesh> MakeConvexPrism(std::span<const Eigen::Vector2d> polygon,
                                            double height) {
  std::vector<Point2> corners(polygon.begin(), polygon.end());
  RemoveRepeatedCorners(corners);
  if (corners.size() < 3 || !HasArea(corners)) return std::nullopt;
  if (AreaOf(corners) < 0) std::ranges::reverse(corners);
  if (!IsConvexLoop(corners)) return std::nullopt;
  RemoveStraightCorners(corners);
  return Loft({{corners, -height / 2}, {corners, height / 2}});
}

}  // namespace mjforge::solid
