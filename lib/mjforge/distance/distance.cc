// Distance of convex shapes by the GJK algorithm, and penetration depth by libccd (EPA).
#include "mjforge/distance/distance.h"

#include <ccd/ccd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace mjforge::distance {
namespace {

using Eigen::Vector3d;

constexpr int kMostIterations = 500;
constexpr double kPrecision = 1e-10;  // error of a distance, as a share of the size

// Simplex with one to four corners: point, segment, triangle or tetrahedron.
struct Simplex {
  std::array<Vector3d, 4> corners;
  int count = 0;
};

// Returns the point of the corners' affine hull that is nearest to the origin, if that point is
// inside the simplex; otherwise returns nullopt, because a smaller simplex contains the nearest
// point of the simplex.
//
// The barycentric coordinates of a point are ratios of lengths, areas or volumes: Ericson,
// "Real-Time Collision Detection", 2004, 3.4. (Eigen's decompositions would take longer to compile
// than the rest of this folder.)
std::optional<Vector3d> NearestInside(const Simplex& simplex) {
  const Vector3d& first = simplex.corners[0];
  if (simplex.count == 1) return first;
  const Vector3d a = simplex.corners[1] - first;
  // Barycentric coordinates of the nearest point, without that of the first corner.
  if (simplex.count == 2) {
    const double weight = -first.dot(a) / a.squaredNorm();
    if (!(weight >= 0 && weight <= 1)) return std::nullopt;
    return first + weight * a;
  }
  const Vector3d b = simplex.corners[2] - first;
  if (simplex.count == 3) {
    const Vector3d normal = a.cross(b);
    const Eigen::Vector2d weights =
        Eigen::Vector2d(normal.dot(b.cross(first)), normal.dot(first.cross(a))) /
        normal.squaredNorm();
    if (!(weights.minCoeff() >= 0 && weights.sum() <= 1)) return std::nullopt;
    return first + (weights.x() * a + weights.y() * b);
  }
  const Vector3d c = simplex.corners[3] - first;
  const Vector3d normal = b.cross(c);
  const Vector3d weights =
      Vector3d(normal.dot(first), first.cross(c).dot(a), b.cross(first).dot(a)) / -normal.dot(a);
  if (!(weights.minCoeff() >= 0 && weights.sum() <= 1)) return std::nullopt;
  return first + (weights.x() * a + weights.y() * b + weights.z() * c);
}

// Returns the simplex of the corners whose bits in `subset` are 1.
Simplex SubsetOf(const Simplex& simplex, int subset) {
  Simplex some;
  for (int i = 0; i < simplex.count; ++i) {
    if ((subset >> i & 1) != 0)
      some.corners[static_cast<std::size_t>(some.count++)] =
          simplex.corners[static_cast<std::size_t>(i)];
  }
  return some;
}

// Reduces a simplex to the corners whose hull contains the point nearest to the origin, and returns
// that point. The newest corner, which is the last, is always kept. A tetrahedron around the origin
// stays as it is.
Vector3d Reduce(Simplex& simplex) {
  if (simplex.count == 4 && NearestInside(simplex)) return Vector3d::Zero();
  double least = std::numeric_limits<double>::infinity();
  Vector3d nearest = Vector3d::Zero();
  int best = 0;
  const int end = std::min(1 << simplex.count, 0b1111);
  for (int subset = 1 << (simplex.count - 1); subset < end; ++subset) {
    const auto point = NearestInside(SubsetOf(simplex, subset));
    if (!point || point->norm() >= least) continue;
    least = point->norm();
    nearest = *point;
    best = subset;
  }
  simplex = SubsetOf(simplex, best);
  return nearest;
}

// Returns the point of a convex set that is nearest to the origin, or any point of the set if all
// points are farther than `limit`, m. `farthest` returns the point of the set that is farthest in a
// direction; `middle` is the approximate centre of the set, `size` its size, m. Source: Gilbert,
// Johnson and Keerthi, "A fast procedure for computing the distance between complex objects in
// three-dimensional space", 1988.
template <typename Farthest>
Vector3d NearestToOrigin(Farthest farthest, const Vector3d& middle, double size,
                         double limit = std::numeric_limits<double>::infinity()) {
  Simplex simplex;
  Vector3d nearest = farthest(middle.isZero() ? Vector3d(Vector3d::UnitX()) : Vector3d(-middle));
  simplex.corners[0] = nearest;
  simplex.count = 1;
  for (int i = 0; i < kMostIterations; ++i) {
    const double distance = nearest.norm();
    if (distance <= kPrecision * size) return Vector3d::Zero();
    const Vector3d next = farthest(-nearest);
    // No point of the set is nearer to the origin than the support plane through `next`.
    const double least = nearest.dot(next) / distance;
    if (least > limit || distance - least <= kPrecision * size) return nearest;
    simplex.corners[static_cast<std::size_t>(simplex.count++)] = next;
    const Vector3d reduced = Reduce(simplex);
    if (reduced.norm() >= distance) return nearest;  // rounding prevents progress
    nearest = reduced;
  }
  return nearest;
}

// Returns the radius around the core of a shape, m. The core of a sphere is its centre, the core of
// a capsule is its segment; other shapes are their own cores, with radius 0.
double RadiusOf(const PlacedShape& placed) {
  const model::Shape& shape = placed.shape;
  const bool is_round =
      shape.type == model::GeomType::kSphere || shape.type == model::GeomType::kCapsule;
  return is_round ? shape.size.x() : 0;
}

// Returns a point of the core of a shape that is farthest in a direction (see RadiusOf()).
Vector3d FarthestOfCore(const PlacedShape& placed, const Vector3d& direction_W) {
  const model::Shape& shape = placed.shape;
  const Vector3d& center = placed.X_WG.p;
  if (shape.type == model::GeomType::kSphere) return center;
  if (shape.type != model::GeomType::kCapsule) return FarthestPoint(placed, direction_W);
  const Vector3d half = placed.R_WG.col(2) * shape.size.y();
  return center + (half.dot(direction_W) > 0 ? 1 : -1) * half;
}

// Penetration depth of two overlapping cores. All lengths are divided by the common size of the
// shapes, because libccd's tolerances are absolute.
class Penetration {
 public:
  Penetration(const PlacedShape& a, const PlacedShape& b, double size)
      : a_(a), b_(b), size_(size) {}

  double Depth() {
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = SupportOfA;
    ccd.support2 = SupportOfB;
    ccd.max_iterations = kMostIterations;
    ccd.epa_tolerance = kPrecision;
    ccd_real_t depth = 0;
    ccd_vec3_t direction;
    ccd_vec3_t position;
    const int answer = ccdGJKPenetration(this, this, &ccd, &depth, &direction, &position);
    if (answer != 0) return 0;  // the cores only touch
    if (calls_ < kMostCalls) return depth * size_;
    return size_ * Refined(Vector3d(direction.v).normalized());
  }

 private:
  // Maximum number of calls of Support(). Further calls return the origin, which stops libccd's
  // refinement, because the origin is no farther than the points that libccd has. Without a limit,
  // libccd would refine its polytope in all directions for nearly concentric round shapes, whose
  // depth is equal in all directions.
  static constexpr int kMostCalls = 1000;

  static void SupportOfA(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
    Support(object, true, direction, point);
  }
  static void SupportOfB(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
    Support(object, false, direction, point);
  }
  static void Support(const void* object, bool first, const ccd_vec3_t* direction,
                      ccd_vec3_t* point) {
    const auto& self = *static_cast<const Penetration*>(object);
    const bool enough = ++self.calls_ > kMostCalls;
    const Vector3d p =
        enough ? Vector3d(Vector3d::Zero())
               : Vector3d((FarthestOfCore(first ? self.a_ : self.b_, Vector3d(direction->v)) -
                           self.b_.X_WG.p) /
                          self.size_);
    ccdVec3Set(point, p.x(), p.y(), p.z());
  }

  // Returns the distance by which A must move against a direction to separate the cores, in units
  // of size_.
  double Reach(const Vector3d& direction) const {
    return direction.dot(FarthestOfCore(a_, direction) - FarthestOfCore(b_, -direction)) / size_;
  }

  // Returns the smallest Reach() among directions near `direction` or near its opposite, found by
  // pattern search.
  double Refined(const Vector3d& direction) const {
    Vector3d best = Reach(direction) < Reach(-direction) ? direction : Vector3d(-direction);
    double least = Reach(best);
    for (double step = 0.2; step > 1e-7;) {
      const Vector3d across = best.unitOrthogonal();
      bool found = false;
      for (int i = 0; i < 8; ++i) {
        const Vector3d turned = Eigen::AngleAxisd(i * M_PI / 4 + 1 / step, best) * across;
        const Vector3d near = (best + step * turned).normalized();
        if (Reach(near) >= least) continue;
        least = Reach(near);
        best = near;
        found = true;
        break;
      }
      if (!found) step /= 2;
    }
    return least;
  }

  const PlacedShape& a_;
  const PlacedShape& b_;
  double size_;
  mutable int calls_ = 0;
};

// Returns the vector from the nearest point of core B to the nearest point of core A, m. If the
// cores are farther apart than `limit`, returns a vector between any two of their points.
Vector3d BetweenCores(const PlacedShape& a, const PlacedShape& b, double size,
                      double limit = std::numeric_limits<double>::infinity()) {
  const auto difference = [&](const Vector3d& direction) {
    return Vector3d(FarthestOfCore(a, direction) - FarthestOfCore(b, -direction));
  };
  return NearestToOrigin(difference, a.box_W.center() - b.box_W.center(), size, limit);
}

double SizeOf(const PlacedShape& a, const PlacedShape& b) {
  return a.box_W.merged(b.box_W).diagonal().norm();
}

// Returns a point of several shapes that is farthest in a direction.
Vector3d FarthestOfHull(std::span<const PlacedShape> shapes, const Vector3d& direction_W) {
  Vector3d farthest = Vector3d::Zero();
  double way = -std::numeric_limits<double>::infinity();
  for (const PlacedShape& placed : shapes) {
    const Vector3d p = FarthestPoint(placed, direction_W);
    if (p.dot(direction_W) <= way) continue;
    way = p.dot(direction_W);
    farthest = p;
  }
  return farthest;
}

}  // namespace

PlacedShape::PlacedShape(const model::Shape& of, const model::Pose& at)
    : shape(of),
      X_WG(at),
      R_WG(at.q.toRotationMatrix()),
      box_W(model::BoundsOf(of, at).ToEigen()) {}

Eigen::AlignedBox3d BoxAround(std::span<const PlacedShape> shapes) {
  Eigen::AlignedBox3d box_W;
  for (const PlacedShape& placed : shapes) box_W.extend(placed.box_W);
  return box_W;
}

Vector3d FarthestPoint(const PlacedShape& placed, const Vector3d& direction_W) {
  const Vector3d direction_G = placed.R_WG.transpose() * direction_W;
  return placed.X_WG.p + placed.R_WG * model::SupportPoint(placed.shape, direction_G);
}

Vector3d Separation(const PlacedShape& a, const PlacedShape& b) {
  const Vector3d cores = BetweenCores(a, b, SizeOf(a, b));
  const double distance = cores.norm();
  const double apart = distance - RadiusOf(a) - RadiusOf(b);
  if (!(apart > 0)) return Vector3d::Zero();
  return cores * (apart / distance);
}

double Distance(const PlacedShape& a, const PlacedShape& b) {
  return DistanceUpTo(std::numeric_limits<double>::infinity(), a, b);
}

double DistanceUpTo(double limit, const PlacedShape& a, const PlacedShape& b) {
  const double cores = BetweenCores(a, b, SizeOf(a, b), limit + RadiusOf(a) + RadiusOf(b)).norm();
  return std::max(cores - RadiusOf(a) - RadiusOf(b), 0.0);
}

double SignedDistance(const PlacedShape& a, const PlacedShape& b) {
  const double size = SizeOf(a, b);
  const double cores = BetweenCores(a, b, size).norm();
  const double apart = cores > 0 ? cores : -Penetration(a, b, size).Depth();
  return apart - RadiusOf(a) - RadiusOf(b);
}

Vector3d FromHull(std::span<const PlacedShape> shapes, const Vector3d& p_W) {
  const auto difference = [&](const Vector3d& direction) {
    return Vector3d(p_W - FarthestOfHull(shapes, -direction));
  };
  const Eigen::AlignedBox3d box_W = BoxAround(shapes);
  return NearestToOrigin(difference, p_W - box_W.center(), box_W.diagonal().norm());
}

}  // namespace mjforge::distance
