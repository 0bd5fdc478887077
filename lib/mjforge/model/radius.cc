// Horizontal radius of shapes: the largest distance of a point from the z axis. Lengths are Eigen's
// norms, because the last bit of std::hypot depends on the processor.

#include <algorithm>
#include <cmath>

#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

// Returns the largest distance from the origin of a point of the ellipse with centre (u, v) and
// half axes a >= b >= 0 along x and y.
//
// The unit vector t maximizes |c + A t| with c = (|u|, |v|) (by symmetry) and A = diag(a, b). A
// Lagrange multiplier gives (l I - A^2) t = A c, and the maximum belongs to the root with l >= a^2
// (this is the trust region problem; More and Sorensen, "Computing a trust region step", 1983).
// With d = l - a^2, t1 = a u / d and t2 = b v / (d + a^2 - b^2), |t| decreases strictly with d.
// Newton's method on 1 / |t| - 1, kept in a bracket, finds the root. An error in d changes the
// distance, which is stationary there, only quadratically.
double FarthestOnEllipse(double u, double v, double a, double b) {
  u = std::abs(u);
  v = std::abs(v);
  const double gap = (a - b) * (a + b);
  // A centre this close to the minor axis is put on it: the error is below the last bit of a.
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

// The distance from the z axis is a convex function, so that it is largest at an extreme point, on
// the rim of an end disc. A disc with unit normal n, seen from above, is an ellipse with half axes
// r across the tilt and r |n_z| along it.
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

// Seen from above, the ellipsoid R diag(s) (unit ball) + p is the ellipse E (unit ball) + p, where
// E is the upper two rows of R diag(s). The half axes are the singular values of E, computed from
// the eigenvalues of the 2 x 2 matrix E E'.
double EllipsoidRadius(const Eigen::Vector3d& size, const Pose& X_AG) {
  const Eigen::Matrix3d scaled = X_AG.q.toRotationMatrix() * size.asDiagonal();
  const Eigen::Vector3d ex = scaled.row(0);
  const Eigen::Vector3d ey = scaled.row(1);
  const double mean = (ex.squaredNorm() + ey.squaredNorm()) / 2;
  const double difference = (ex.squaredNorm() - ey.squaredNorm()) / 2;
  const double mixed = ex.dot(ey);
  const double a = std::sqrt(mean + Eigen::Vector2d(difference, mixed).norm());
  const double b = ex.cross(ey).norm() / a;                // a b is the area / pi
  const double angle = std::atan2(mixed, difference) / 2;  // angle of the major axis
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return FarthestOnEllipse(c * X_AG.p.x() + s * X_AG.p.y(), c * X_AG.p.y() - s * X_AG.p.x(), a,
                           std::min(a, b));
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
