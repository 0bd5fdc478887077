#include "mjforge/expect/distance.h"

#include <ccd/ccd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace mjforge::expect {
namespace {

using Eigen::Vector3d;

constexpr int kMostIterations = 500;
// Of the size: how near to the true distance is near enough.
constexpr double kPrecision = 1e-10;

// A point, a segment, a triangle or a tetrahedron.
struct Simplex {
  std::array<Vector3d, 4> corners;
  int count = 0;
};

// The point of the hull of some corners that is nearest to the origin, if it is inside of it and
// not in the hull of fewer.
template <int kEdges>
std::optional<Vector3d> NearestInside(const Simplex& simplex) {
  const Vector3d& first = simplex.corners[0];
  Eigen::Matrix<double, 3, kEdges> edges;
  for (int i = 0; i < kEdges; ++i)
    edges.col(i) = simplex.corners[static_cast<std::size_t>(i) + 1] - first;
  const Eigen::Matrix<double, kEdges, 1> weights = edges.colPivHouseholderQr().solve(-first);
  if (!weights.allFinite() || weights.minCoeff() < 0 || weights.sum() > 1) return std::nullopt;
  return first + edges * weights;
}

std::optional<Vector3d> NearestInside(const Simplex& simplex) {
  switch (simplex.count) {
    case 1:
      return simplex.corners[0];
    case 2:
      return NearestInside<1>(simplex);
    case 3:
      return NearestInside<2>(simplex);
    default:
      return NearestInside<3>(simplex);
  }
}

// Keeps the corners that the point nearest to the origin depends on. The last one, which is new, is
// among them.
Vector3d Reduce(Simplex& simplex) {
  double least = std::numeric_limits<double>::infinity();
  Vector3d nearest = Vector3d::Zero();
  Simplex best;
  for (int subset = 1 << (simplex.count - 1); subset < 1 << simplex.count; ++subset) {
    Simplex some;
    for (int i = 0; i < simplex.count; ++i) {
      if ((subset >> i & 1) != 0)
        some.corners[static_cast<std::size_t>(some.count++)] =
            simplex.corners[static_cast<std::size_t>(i)];
    }
    const auto point = NearestInside(some);
    if (!point || point->norm() >= least) continue;
    least = point->norm();
    nearest = *point;
    best = some;
  }
  simplex = best;
  return nearest;
}

// The point nearest to the origin of a convex set, known by its farthest point in each direction:
// Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between complex
// objects in three-dimensional space", 1988. `middle`: of the set, about; `size`: of the set, m.
template <typename Farthest>
Vector3d NearestToOrigin(Farthest farthest, const Vector3d& middle, double size) {
  Simplex simplex;
  Vector3d nearest = farthest(middle.isZero() ? Vector3d(Vector3d::UnitX()) : Vector3d(-middle));
  simplex.corners[0] = nearest;
  simplex.count = 1;
  for (int i = 0; i < kMostIterations; ++i) {
    const double distance = nearest.norm();
    if (distance <= kPrecision * size) return Vector3d::Zero();
    const Vector3d next = farthest(-nearest);
    // The whole set is beyond the plane through `next`.
    if (distance - nearest.dot(next) / distance <= kPrecision * size) return nearest;
    if (simplex.count == 4) return Vector3d::Zero();
    simplex.corners[static_cast<std::size_t>(simplex.count++)] = next;
    const Vector3d reduced = Reduce(simplex);
    if (simplex.count == 4) return Vector3d::Zero();  // the origin is inside
    if (reduced.norm() >= distance) return nearest;   // no better within rounding
    nearest = reduced;
  }
  return nearest;
}

Eigen::AlignedBox3d BoxOf(const model::Box3& box) { return {box.min, box.max}; }

// A sphere is a point and all within its radius, a capsule a segment.
double RadiusOf(const Solid& solid) {
  const model::Shape& shape = solid.part->shape;
  const bool is_round =
      shape.type == model::GeomType::kSphere || shape.type == model::GeomType::kCapsule;
  return is_round ? shape.size.x() : 0;
}

// The farthest point of what is left of a solid without its radius.
Vector3d FarthestOfCore(const Solid& solid, const Vector3d& direction_W) {
  const model::Shape& shape = solid.part->shape;
  const Vector3d& center = solid.X_WG.p;
  if (shape.type == model::GeomType::kSphere) return center;
  if (shape.type != model::GeomType::kCapsule) return FarthestPoint(solid, direction_W);
  const Vector3d half = solid.X_WG.q * Vector3d(0, 0, shape.size.y());
  return center + (half.dot(direction_W) > 0 ? 1 : -1) * half;
}

// Two cores that overlap. libccd's tolerances are absolute, so it sees them in units of their size.
class Overlapping {
 public:
  Overlapping(const Solid& a, const Solid& b, double size) : a_(a), b_(b), size_(size) {}

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
    if (answer != 0) return 0;  // they only touch
    if (calls_ < kMostCalls) return depth * size_;
    return size_ * Refined(Vector3d(direction.v).normalized());
  }

 private:
  // Round things that are nearly concentric are as deep in all directions, and libccd would look
  // at each of them: from here on no point is farther than those it has.
  static constexpr int kMostCalls = 1000;

  static void SupportOfA(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
    Support(object, true, direction, point);
  }
  static void SupportOfB(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
    Support(object, false, direction, point);
  }
  static void Support(const void* object, bool first, const ccd_vec3_t* direction,
                      ccd_vec3_t* point) {
    const auto& self = *static_cast<const Overlapping*>(object);
    const bool enough = ++self.calls_ > kMostCalls;
    const Vector3d p =
        enough ? Vector3d(Vector3d::Zero())
               : Vector3d((FarthestOfCore(first ? self.a_ : self.b_, Vector3d(direction->v)) -
                           self.b_.X_WG.p) /
                          self.size_);
    ccdVec3Set(point, p.x(), p.y(), p.z());
  }

  // How far one reaches into the other against a direction.
  double Reach(const Vector3d& direction) const {
    return direction.dot(FarthestOfCore(a_, direction) - FarthestOfCore(b_, -direction)) / size_;
  }

  // The least reach near a direction; either way is meant.
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

  const Solid& a_;
  const Solid& b_;
  double size_;
  mutable int calls_ = 0;
};

}  // namespace

Solid::Solid(const model::Part* of, const model::Pose& at)
    : part(of), X_WG(at), box_W(BoxOf(model::BoundsOf(of->shape, at))) {}

Vector3d FarthestPoint(const Solid& solid, const Vector3d& direction_W) {
  const Eigen::Quaterniond& q_WG = solid.X_WG.q;
  return solid.X_WG * model::SupportPoint(solid.part->shape, q_WG.conjugate() * direction_W);
}

Vector3d FarthestPoint(std::span<const Solid> solids, const Vector3d& direction_W) {
  Vector3d farthest = Vector3d::Zero();
  double way = -std::numeric_limits<double>::infinity();
  for (const Solid& solid : solids) {
    const Vector3d p = FarthestPoint(solid, direction_W);
    if (p.dot(direction_W) <= way) continue;
    way = p.dot(direction_W);
    farthest = p;
  }
  return farthest;
}

double SignedDistance(const Solid& a, const Solid& b) {
  const double size = a.box_W.merged(b.box_W).diagonal().norm();
  const auto difference = [&](const Vector3d& direction) {
    return Vector3d(FarthestOfCore(a, direction) - FarthestOfCore(b, -direction));
  };
  const double distance =
      NearestToOrigin(difference, a.box_W.center() - b.box_W.center(), size).norm();
  const double apart = distance > 0 ? distance : -Overlapping(a, b, size).Depth();
  return apart - RadiusOf(a) - RadiusOf(b);
}

Vector3d FromHull(std::span<const Solid> solids, const Vector3d& p_W) {
  const auto difference = [&](const Vector3d& direction) {
    return Vector3d(p_W - FarthestPoint(solids, -direction));
  };
  Eigen::AlignedBox3d box_W;
  for (const Solid& solid : solids) box_W.extend(solid.box_W);
  return NearestToOrigin(difference, p_W - box_W.center(), box_W.diagonal().norm());
}

}  // namespace mjforge::expect
