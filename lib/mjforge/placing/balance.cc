// Hull of the contacts that carry a body, and its distance from the centre of mass.

#include "mjforge/placing/balance.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "mjforge/placing/footprint.h"
#include "mjforge/solid/solid.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFaces = 0.99;   // least z of the normal of a contact of level faces
constexpr double kCarries = 0.1;  // least z of the normal of a contact that carries the body
constexpr double kTolerance = 0.05;

// Returns the points of the contacts that carry the body, seen from above. A shape that lies on a
// level face touches it with all of its lowest points, other shapes touch with a single point.
std::vector<Vector2d> CarryingPoints(std::span<const distance::PlacedShape> shapes,
                                     std::span<const Contact> contacts) {
  constexpr double kTouching = 1e-4;  // m
  std::vector<Vector2d> points;
  for (const Contact& contact : contacts) {
    const distance::PlacedShape& shape = shapes[contact.shape];
    if (contact.normal_W.z() >= kFaces) {
      std::ranges::copy(FootprintOf({&shape, 1}, kTouching).Outline(), std::back_inserter(points));
    } else if (contact.normal_W.z() >= kCarries) {
      points.emplace_back(distance::FarthestPoint(shape, -contact.normal_W).head<2>());
    }
  }
  return points;
}

double DistanceToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp(along.dot(p - a) / length, 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

// Returns the distance of a point from the convex hull of points; 0 inside.
double DistanceToHull(const Vector2d& p, std::vector<Vector2d> points) {
  const Polygon hull = solid::ConvexPolygonOf(std::move(points));
  double distance = std::numeric_limits<double>::infinity();
  bool is_inside = hull.size() > 2;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d& a = hull[i];
    const Vector2d& b = hull[(i + 1) % hull.size()];
    distance = std::min(distance, DistanceToSegment(p, a, b));
    const Vector2d edge = b - a;
    is_inside &= edge.x() * (p - a).y() >= edge.y() * (p - a).x();
  }
  return is_inside ? 0 : distance;
}

}  // namespace

bool IsBalanced(std::span<const distance::PlacedShape> shapes, std::span<const Contact> contacts,
                const Vector3d& center_of_mass) {
  Eigen::AlignedBox3d box;
  for (const distance::PlacedShape& shape : shapes) box.extend(shape.box_W);
  const double width = box.sizes().head<2>().norm();
  return DistanceToHull(center_of_mass.head<2>(), CarryingPoints(shapes, contacts)) <=
         kTolerance * width;
}

}  // namespace mjforge::placing
