// Area, convex hull, clipping and containment of polygons in a plane.

#include "mjforge/solid/polygon.h"

#include <algorithm>
#include <utility>

namespace mjforge::solid {

double AreaOf(std::span<const Point2> corners) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    twice += Turn(corners[0], corners[i], corners[i + 1]);
  }
  return twice / 2;
}

Point2 OutwardNormal(std::span<const Point2> corners, std::size_t i) {
  const Point2 along = corners[(i + 1) % corners.size()] - corners[i];
  return Point2(along.y(), -along.x()).stableNormalized();
}

// Source: Sutherland and Hodgman, "Reentrant polygon clipping", 1974, here for one line.
std::vector<Point2> Clipped(std::span<const Point2> corners, const Point2& normal, double limit) {
  std::vector<Point2> rest;
  rest.reserve(corners.size() + 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& a = corners[i];
    const Point2& b = corners[(i + 1) % corners.size()];
    const double beyond_a = normal.dot(a) - limit;
    const double beyond_b = normal.dot(b) - limit;
    if (beyond_a <= 0) rest.push_back(a);
    if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0))
      rest.emplace_back(a + (b - a) * (beyond_a / (beyond_a - beyond_b)));
  }
  return rest;
}

double DistanceToSegment(const Point2& p, const Point2& from, const Point2& to) {
  const Point2 side = to - from;
  const double length = side.squaredNorm();
  const double share = length > 0 ? std::clamp((p - from).dot(side) / length, 0.0, 1.0) : 0;
  return (from + share * side - p).norm();
}

bool ConvexContains(std::span<const Point2> corners, const Point2& p) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (Turn(corners[i], corners[(i + 1) % corners.size()], p) < 0) return false;
  }
  return corners.size() > 2;
}

// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
std::vector<Point2> ConvexPolygonOf(std::vector<Point2> points, double straight) {
  std::ranges::sort(points, [](const Point2& a, const Point2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> hull;
  const auto add = [&](const Point2& p, std::size_t least) {
    while (hull.size() > least) {
      const Point2 edge = hull.back() - hull[hull.size() - 2];
      const Point2 next = p - hull.back();
      const double least_cross = straight > 0 ? straight * edge.norm() * next.norm() : 0;
      if (Cross(edge, next) > least_cross) break;
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Point2& p : points) add(p, 1);
  const std::size_t upper = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], upper);
  hull.pop_back();  // removes the repeated first point
  return hull;
}

}  // namespace mjforge::solid
