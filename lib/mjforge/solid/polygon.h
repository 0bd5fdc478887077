// Polygons in a plane: area, convex hull, clipping.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Dense>

namespace mjforge::solid {

/// A point or a vector in the plane, m.
using Point2 = Eigen::Vector2d;

inline double Cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns the bounding box of points in the plane or in space.
template <typename Points>
auto BoxAround(const Points& points) {
  Eigen::AlignedBox<double, Points::value_type::SizeAtCompileTime> box;
  for (const auto& p : points) box.extend(p);
  return box;
}

/// Returns the points with these indices.
template <typename Point>
std::vector<Point> PointsAt(const std::vector<Point>& points, const std::vector<int>& indices) {
  std::vector<Point> some;
  some.reserve(indices.size());
  for (const int i : indices) some.push_back(points[static_cast<std::size_t>(i)]);
  return some;
}

/// Returns twice the signed area of the triangle, positive if it is counter-clockwise.
inline double Turn(const Point2& a, const Point2& b, const Point2& c) {
  return Cross(b - a, c - a);
}

/// Returns the signed area, m^2, positive if the corners are counter-clockwise.
double AreaOf(std::span<const Point2> corners);

/// Returns a unit vector that points away from a counter-clockwise polygon at the edge that begins
/// at corner i.
Point2 OutwardNormal(std::span<const Point2> corners, std::size_t i);

/// Returns the distance of a point from a segment, m. The ends of the segment may coincide.
double DistanceToSegment(const Point2& p, const Point2& from, const Point2& to);

/// Returns the part of a convex polygon in which dot(normal, p) <= limit; empty if there is none.
std::vector<Point2> Clipped(std::span<const Point2> corners, const Point2& normal, double limit);

/// Returns true if a convex polygon contains a point. Less than three corners contain nothing.
bool ConvexContains(std::span<const Point2> corners, const Point2& p);

/// Returns the convex hull, counter-clockwise, without straight corners, at which the sine of the
/// angle between the two edges is at most `straight`.
std::vector<Point2> ConvexPolygonOf(std::vector<Point2> points, double straight = 0);

}  // namespace mjforge::solid
