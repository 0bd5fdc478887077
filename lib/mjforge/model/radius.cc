// Horizontal radius of shapes: the largest distance of a point from the z axis. Lengths are
// computed by Eigen's norm(), because the last bit of std::hypot depends on the processor.

#include <algorithm>
#include <cmath>
#include <utility>

#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

// Returns the largest distance between the origin and a point of the ellipse with centre (u, v) and
// half axes a >= b >= 0 along x and y.
//
// The unit vector t maximizes |c + A t| with c = (|u|, |v|) (by symmetry) and A = diag(a, b). A
// Lagrange multiplier l gives (l I - A^2) t = A c, and the maximum belongs to the root with l >=
// a^2 (this is the trust region problem; More and Sorensen, "Computing a trust region step", 1983).
// With d = l - a^2, t1 = a u / d and t2 = b v / (d + a^2 - b^2), |t| decreases strictly with d.
// Newton's method on 1 / |t| - 1, restricted to a bracket, finds the root. The distance is
// stationary at the root; therefore an error in d changes the distance only quadratically.
double FarthestOnEllipse(double u, double v, double a, double b) {
  u = std::abs(u);
  v = std::abs(v);
  const double gap = (a - b) * (a + b);
  // A centre this close to the minor axis is treated as if it were on the axis; the error is below
  // the last bit of a.
  if (u < 1e-18 * a) {
    const double t2 = b * v >= gap ? 1 : b * v / gap;
    return Eigen::Vector2d(a * std::sqrt(1 - t2 * t2), v + b * t2).norm();
  }
  double lo = std::max(a * u, b * v - gap);
  double hi = Eigen::Vector2d(a * u, b * v).norm();
  double d = lo;
  for (int i = 0; i < 100 && lo < hi; ++i) {
    const double t1 = a * u / d;
    const double t2 = b * v / (d + gap);
    const double norm = Eigen::Vector2d(t1, t2).norm();
    (norm > 1 ? lo : hi) = d;
    const double slope = (t1 * t1 / d + t2 * t2 / (d + gap)) / (norm * norm * norm);
    double next = d + (1 - 1 / norm) / slope;
    if (!(next >= lo && next <= hi)) next = lo + (hi - lo) / 2;
    if (std::abs(next - d) <= 1e-16 * d) break;
    d = next;
  }
  Eigen::Vector2d t(a * u / d, b * v / (d + gap));
  t.normalize();
  return Eigen::Vector2d(u + a * t.x(), v + b * t.y()).norm();
}

// Returns the horizontal radius of a cylinder. The distance from the z axis is a convex function
// and therefore largest at an extreme point of the cylinder, on the rim of an end disc. Seen from
// above, a disc with the unit normal n is an ellipse, with half axes r across the tilt and r |n_z|
// along the tilt.
double CylinderRadius(double radius, double half_length, const Pose& X_AG) {
  const Eigen::Vector3d n = X_AG.q * Eigen::Vector3d::UnitZ();
  const double tilt = n.head<2>().norm();
  const Eigen::Vector2d along =
      tilt > 0 ? Eigen::Vector2d(n.head<2>() / tilt) : Eigen::Vector2d(1, 0);
  double largest = 0;
  for (const double end : {-half_length, half_length}) {
    const Eigen::Vector2d c = (X_AG.p + end * n).head<2>();
    const double across = along.x() * c.y() - along.y() * c.x();
    largest = std::max(largest,
                       FarthestOnEllipse(across, along.dot(c), radius, radius * std::abs(n.z())));
  }
  return largest;
}

// Returns the largest distance between the origin and a point of the ellipse E (unit ball) + p,
// where the rows of E are ex and ey. The half axes are the singular values of E, which are computed
// from the eigenvalues of the 2 x 2 matrix E E'.
double EllipseRadius(const Eigen::Vector3d& ex, const Eigen::Vector3d& ey,
                     const Eigen::Vector2d& p) {
  const double mean = (ex.squaredNorm() + ey.squaredNorm()) / 2;
  const double difference = (ex.squaredNorm() - ey.squaredNorm()) / 2;
  const double mixed = ex.dot(ey);
  const double a = std::sqrt(mean + Eigen::Vector2d(difference, mixed).norm());
  if (a == 0) return p.norm();
  const double b = ex.cross(ey).norm() / a;                // a b is the area / pi
  const double angle = std::atan2(mixed, difference) / 2;  // angle of the major axis
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return FarthestOnEllipse(c * p.x() + s * p.y(), c * p.y() - s * p.x(), a, std::min(a, b));
}

// Returns the horizontal radius of an ellipsoid R diag(s) (unit ball) + p. Seen from above, it is
// the ellipse whose matrix E consists of the upper two rows of R diag(s).
double EllipsoidRadius(const Eigen::Vector3d& size, const Pose& X_AG) {
  const Eigen::Matrix3d scaled = X_AG.q.toRotationMatrix() * size.asDiagonal();
  return EllipseRadius(scaled.row(0), scaled.row(1), X_AG.p.head<2>());
}

// Returns the largest local maximum, within an arc, of the distance from the z axis; 0 if there is
// none. On the arc q = p + cos(t) u + sin(t) v, the derivative of the squared distance has at most
// four roots. The maxima are the roots at which the derivative changes from positive to negative;
// they are bracketed, then bisected.
double ArcRadius(const Eigen::Vector2d& p, const Eigen::Vector2d& u, const Eigen::Vector2d& v,
                 double angle) {
  constexpr int kSteps = 32;
  const auto at = [&](double t) { return Eigen::Vector2d(p + std::cos(t) * u + std::sin(t) * v); };
  const auto slope = [&](double t) { return at(t).dot(std::cos(t) * v - std::sin(t) * u); };
  double largest = 0;
  double after = slope(0);
  for (int i = 0; i < kSteps; ++i) {
    double lo = angle * i / kSteps;
    double hi = angle * (i + 1) / kSteps;
    const double before = std::exchange(after, slope(hi));
    if (!(before > 0 && after <= 0)) continue;
    for (int k = 0; k < 60; ++k) {
      const double middle = lo + (hi - lo) / 2;
      if (middle == lo || middle == hi) break;
      (slope(middle) > 0 ? lo : hi) = middle;
    }
    largest = std::max(largest, at(lo).norm());
  }
  return largest;
}

double BoxRadius(const Eigen::Vector3d& size, const Pose& X_AG) {
  const Eigen::Matrix3d scaled = X_AG.q.toRotationMatrix() * size.asDiagonal();
  double largest = 0;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        const Eigen::Vector3d corner = X_AG.p + scaled * Eigen::Vector3d(x, y, z);
        largest = std::max(largest, corner.head<2>().squaredNorm());
      }
    }
  }
  return std::sqrt(largest);
}

double MeshRadius(const TriangleMesh& mesh, const Pose& X_AG) {
  const Eigen::Matrix3d R_AG = X_AG.q.toRotationMatrix();
  double largest = 0;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    const Eigen::Vector3d p_A = X_AG.p + R_AG * vertex;
    largest = std::max(largest, p_A.head<2>().squaredNorm());
  }
  return std::sqrt(largest);
}

}  // namespace

double HorizontalRadius(const solid::Extent& extent, const Pose& X_AS) {
  const Eigen::Matrix3d R_AS = X_AS.q.toRotationMatrix();
  double largest = 0;
  for (const solid::ExtentCurve& curve : extent) {
    const Eigen::Vector2d p = (X_AS * curve.center).head<2>();
    const Eigen::Vector2d u = (R_AS * curve.u).head<2>();
    const Eigen::Vector2d v = (R_AS * curve.v).head<2>();
    if (p.norm() + u.norm() + v.norm() + curve.round <= largest) continue;
    const double radius = curve.is_whole() ? EllipseRadius({u.x(), v.x(), 0}, {u.y(), v.y(), 0}, p)
                                           : ArcRadius(p, u, v, curve.angle);
    if (radius > 0 || curve.is_whole()) largest = std::max(largest, radius + curve.round);
  }
  return largest;
}

double HorizontalRadius(const Shape& shape, const Pose& X_AG) {
  const Eigen::Vector3d& s = shape.size;
  switch (shape.type) {
    case GeomType::kSphere:
      return X_AG.p.head<2>().norm() + s.x();
    case GeomType::kCapsule: {
      const Eigen::Vector3d half = X_AG.q * Eigen::Vector3d(0, 0, s.y());
      return std::max((X_AG.p + half).head<2>().norm(), (X_AG.p - half).head<2>().norm()) + s.x();
    }
    case GeomType::kEllipsoid:
      return EllipsoidRadius(s, X_AG);
    case GeomType::kCylinder:
      return CylinderRadius(s.x(), s.y(), X_AG);
    case GeomType::kBox:
      return BoxRadius(s, X_AG);
    case GeomType::kMesh:
      return MeshRadius(*shape.mesh, X_AG);
  }
  return 0;
}

}  // namespace mjforge::model
