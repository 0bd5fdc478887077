// Footprints of convex shapes, cut off at a level plane.

#include "mjforge/placing/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "mjforge/solid/solid.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kOutlinePoints = 64;  // points of a circle or ellipsoid
constexpr int kGenerators = 256;    // lines on the side of a tilted cylinder
constexpr int kCapsuleSteps = 32;
constexpr double kLevel = 1e-9;  // tolerance of level axes: sine of the tilt, or rise in m
// Largest number of pairs of a vertex below the plane and a vertex above it for which all
// connecting lines are cut with the plane. For larger meshes, only the edges of the convex hull are
// cut.
constexpr std::size_t kMostPairs = 100'000;

Vector2d UnitAt(int i) {
  const double angle = 2 * std::numbers::pi * i / kOutlinePoints;
  return {std::cos(angle), std::sin(angle)};
}

// Collects discs and points in the xy plane. Their convex hull is the convex hull, seen from above,
// of all points of convex shapes below a level plane.
class Slicer {
 public:
  explicit Slicer(double level) : level_(level) {}

  void Add(const distance::PlacedShape& placed) {
    if (placed.box_W.min().z() > level_) return;
    const Vector3d& size = placed.shape.size;
    const Vector3d& center = placed.X_WG.p;
    const Vector3d axis = placed.X_WG.q * Vector3d::UnitZ();
    switch (placed.shape.type) {
      case model::GeomType::kSphere:
        AddBall(center, size.x());
        break;
      case model::GeomType::kCapsule:
        AddCapsule(center, size.y() * (axis.z() < 0 ? Vector3d(-axis) : axis), size.x());
        break;
      case model::GeomType::kCylinder:
        AddCylinder(center, axis, size);
        break;
      case model::GeomType::kEllipsoid:
        AddEllipsoid(center, placed.X_WG.q.toRotationMatrix() * size.asDiagonal());
        break;
      case model::GeomType::kBox:
      case model::GeomType::kMesh: {
        std::vector<Vector3d> vertices = model::VerticesOf(placed.shape);
        for (Vector3d& vertex : vertices) vertex = placed.X_WG * vertex;
        AddHull(vertices);
        break;
      }
    }
  }

  // Returns the discs, and points as discs of radius 0; omits discs inside another disc, and points
  // inside the hull of all points.
  std::vector<Disc> Discs() {
    std::vector<Disc> discs;
    for (const Disc& disc : discs_) {
      const auto is_inside = [](const Disc& a, const Disc& b) {
        return (a.center - b.center).norm() + a.radius <= b.radius;
      };
      if (std::ranges::any_of(discs, [&](const Disc& other) { return is_inside(disc, other); }))
        continue;
      std::erase_if(discs, [&](const Disc& other) { return is_inside(other, disc); });
      discs.push_back(disc);
    }
    for (const Vector2d& point : solid::ConvexPolygonOf(std::move(points_)))
      discs.push_back({point, 0});
    return discs;
  }

 private:
  void AddBall(const Vector3d& center, double radius) {
    const double above = std::max(center.z() - level_, 0.0);
    if (above > radius) return;
    discs_.push_back({center.head<2>(), std::sqrt((radius - above) * (radius + above))});
  }

  // Adds discs of balls along the axis of a capsule, from its lower end to the last ball that
  // reaches below the plane.
  void AddCapsule(const Vector3d& center, const Vector3d& half, double radius) {
    const Vector3d low = center - half;
    const double rise = 2 * half.z();
    const bool is_level = rise <= kLevel;
    const double end = is_level ? 1 : std::min(1.0, (level_ + radius - low.z()) / rise);
    const int steps = is_level ? 1 : kCapsuleSteps;
    for (int i = 0; i <= steps; ++i) {
      // Spaces the balls more closely towards the end, where the radius of their discs shrinks
      // fastest: like the square root of the distance to the end.
      const double rest = 1 - static_cast<double>(i) / steps;
      AddBall(low + 2 * half * (end * (1 - rest * rest)), radius);
    }
  }

  void AddCylinder(const Vector3d& center, const Vector3d& axis, const Vector3d& size) {
    const Vector2d tilt = axis.head<2>();
    if (tilt.norm() <= kLevel) {
      discs_.push_back({center.head<2>(), size.x()});
      return;
    }
    // Adds points on the rims and on the lines along the side, which are the extreme points.
    const Vector3d across = Vector3d(-tilt.y(), tilt.x(), 0).normalized();
    const Vector3d steep = across.cross(axis);
    for (int i = 0; i < kGenerators; ++i) {
      const double angle = 2 * std::numbers::pi * i / kGenerators;
      const Vector3d radial = size.x() * (std::cos(angle) * steep + std::sin(angle) * across);
      const Vector3d a = center + radial + size.y() * axis;
      const Vector3d b = center + radial - size.y() * axis;
      if (a.z() <= level_) points_.emplace_back(a.head<2>());
      if (b.z() <= level_) points_.emplace_back(b.head<2>());
      if ((a.z() <= level_) != (b.z() <= level_)) AddCrossing(a, b);
    }
    for (const double end : {-size.y(), size.y()}) {
      // Adds the points at which the rim crosses the plane.
      const Vector3d middle = center + end * axis;
      const double cosine = (level_ - middle.z()) / (size.x() * steep.z());
      if (!(std::abs(cosine) < 1)) continue;
      const double sine = std::sqrt(1 - cosine * cosine);
      for (const double sign : {-sine, sine})
        points_.emplace_back((middle + size.x() * (cosine * steep + sign * across)).head<2>());
    }
  }

  // Adds the farthest point of an ellipsoid, below the plane, in each direction. The ellipsoid is
  // the image of the unit ball under x = center + matrix y.
  void AddEllipsoid(const Vector3d& center, const Eigen::Matrix3d& matrix) {
    const Vector3d up = matrix.row(2);  // the plane is up . y = level - center.z
    const double height = up.norm();
    const double offset = (level_ - center.z()) / height;
    for (int i = 0; i < kOutlinePoints; ++i) {
      const Vector3d way = matrix.topRows<2>().transpose() * UnitAt(i);
      Vector3d y = way.normalized();
      if (y.dot(up) > offset * height) {
        const Vector3d normal = up / height;
        const Vector3d in_plane = (way - way.dot(normal) * normal).stableNormalized();
        y = offset * normal + std::sqrt(std::max(0.0, 1 - offset * offset)) * in_plane;
      }
      points_.emplace_back((center + matrix * y).head<2>());
    }
  }

  // Adds the extreme points of a hull below the plane: vertices, and points at which the segment
  // between two vertices crosses the plane.
  void AddHull(std::span<const Vector3d> vertices) {
    std::vector<Vector3d> below;
    std::vector<Vector3d> above;
    for (const Vector3d& p : vertices) (p.z() <= level_ ? below : above).push_back(p);
    for (const Vector3d& p : below) points_.emplace_back(p.head<2>());
    if (below.size() * above.size() <= kMostPairs) {
      for (const Vector3d& a : below) {
        for (const Vector3d& b : above) AddCrossing(a, b);
      }
      return;
    }
    solid::Fault fault;
    const std::optional<solid::Polytope> hull = solid::HullOf(vertices, fault);
    if (!hull) return;  // a flat mesh, which MuJoCo rejects
    for (const solid::Polytope::Face& face : hull->faces) {
      Vector3d last = hull->vertices[static_cast<std::size_t>(face.corners.back())];
      for (const int corner : face.corners) {
        const Vector3d& next = hull->vertices[static_cast<std::size_t>(corner)];
        if ((last.z() <= level_) != (next.z() <= level_)) AddCrossing(last, next);
        last = next;
      }
    }
  }

  void AddCrossing(const Vector3d& a, const Vector3d& b) {
    const double share = (level_ - a.z()) / (b.z() - a.z());
    points_.emplace_back((a + share * (b - a)).head<2>());
  }

  double level_;
  std::vector<Disc> discs_;
  std::vector<Vector2d> points_;
};

}  // namespace

Footprint::Footprint(std::vector<Disc> discs) : discs_(std::move(discs)) {
  for (const Disc& disc : discs_) {
    box_.extend(Vector2d(disc.center.array() - disc.radius));
    box_.extend(Vector2d(disc.center.array() + disc.radius));
  }
}

Footprint Footprint::Turned(double angle) const {
  const Eigen::Rotation2Dd turn(angle);
  std::vector<Disc> discs = discs_;
  for (Disc& disc : discs) disc.center = turn * disc.center;
  return Footprint(std::move(discs));
}

double Footprint::Support(const Vector2d& direction) const {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Disc& disc : discs_) {
    const double round = disc.radius > 0 ? disc.radius * direction.norm() : 0;
    farthest = std::max(farthest, direction.dot(disc.center) + round);
  }
  return farthest;
}

Polygon Footprint::Outline() const {
  std::vector<Vector2d> points;
  for (const Disc& disc : discs_) {
    const int count = disc.radius > 0 ? kOutlinePoints : 1;
    for (int i = 0; i < count; ++i) points.emplace_back(disc.center + disc.radius * UnitAt(i));
  }
  return solid::ConvexPolygonOf(std::move(points));
}

Footprint FootprintOf(std::span<const distance::PlacedShape> shapes, double height) {
  if (shapes.empty()) return Footprint({Disc()});
  Slicer slicer(distance::BoxAround(shapes).min().z() + height);
  for (const distance::PlacedShape& placed : shapes) slicer.Add(placed);
  return Footprint(slicer.Discs());
}

}  // namespace mjforge::placing
