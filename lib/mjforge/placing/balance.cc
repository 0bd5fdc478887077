// Hull of the contacts that carry a body, and its distance from the centre of mass.

#include "mjforge/placing/balance.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "mjforge/placing/footprint.h"
#include "mjforge/solid/solid.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFaces = 0.99;      // least z of the normal between two level faces in contact
constexpr double kCarries = 0.1;     // least z of the normal of a contact that carries the body
constexpr double kTouching = 1e-4;   // height, m, of the points that belong to a level face
constexpr double kTolerance = 0.05;  // largest distance from the hull, as a share of the width

// Returns the upper face of a shape, seen from above.
Polygon UpperFaceOf(const distance::PlacedShape& shape) {
  const model::Pose upside_down{Vector3d::Zero(), Eigen::Quaterniond(0, 1, 0, 0)};
  const distance::PlacedShape turned(shape.shape, upside_down * shape.X_WG);
  Polygon face = FootprintOf({&turned, 1}, kTouching).Outline();
  for (Vector2d& corner : face) corner.y() = -corner.y();
  std::ranges::reverse(face);
  return face;
}

// Returns the area, seen from above, in which the lower face of a shape touches the upper face of
// an obstacle; a point where both have an edge or a corner there.
Polygon TouchingArea(const distance::PlacedShape& shape, const Contact& contact) {
  Polygon area = FootprintOf({&shape, 1}, kTouching).Outline();
  Polygon other = UpperFaceOf(*contact.obstacle);
  if (other.size() < 3) std::swap(area, other);
  if (other.size() < 3) return {distance::FarthestPoint(shape, -contact.normal_W).head<2>()};
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Vector2d outward = solid::OutwardNormal(other, i);
    area = solid::Clipped(area, outward, outward.dot(other[i]));
  }
  return area;
}

// Returns the points of the contacts that carry the body, seen from above. A shape that lies on a
// level face touches the face in an area, other shapes touch with a single point.
std::vector<Vector2d> CarryingPoints(std::span<const distance::PlacedShape> shapes,
                                     std::span<const Contact> contacts) {
  std::vector<Vector2d> points;
  for (const Contact& contact : contacts) {
    const distance::PlacedShape& shape = shapes[contact.shape];
    if (contact.normal_W.z() >= kFaces) {
      std::ranges::copy(TouchingArea(shape, contact), std::back_inserter(points));
    } else if (contact.normal_W.z() >= kCarries) {
      points.emplace_back(distance::FarthestPoint(shape, -contact.normal_W).head<2>());
    }
  }
  return points;
}

// Returns the distance of a point from the convex hull of points; 0 inside.
double DistanceToHull(const Vector2d& p, std::vector<Vector2d> points) {
  const Polygon hull = solid::ConvexPolygonOf(std::move(points));
  if (solid::ConvexContains(hull, p)) return 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i)
    distance =
        std::min(distance, solid::DistanceToSegment(p, hull[i], hull[(i + 1) % hull.size()]));
  return distance;
}

}  // namespace

bool IsBalanced(std::span<const distance::PlacedShape> shapes, std::span<const Contact> contacts,
                const Vector3d& center_of_mass) {
  const double width = distance::BoxAround(shapes).sizes().head<2>().norm();
  return DistanceToHull(center_of_mass.head<2>(), CarryingPoints(shapes, contacts)) <=
         kTolerance * width;
}

}  // namespace mjforge::placing
