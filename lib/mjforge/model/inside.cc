// Point test: whether a point is inside a shape, or inside a colliding part of an object.

#include <algorithm>
#include <cmath>

#include "mjforge/model/model.h"
#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

// Relative tolerance of the point test. A point on the surface counts as inside, but its computed
// coordinates have rounding errors: a few units in the last place of the numbers from which they
// are computed.
constexpr double kDoubleRounding = 1e-14;

double SegmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                       const Eigen::Vector3d& b) {
  const Eigen::Vector3d ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0;
  return (p - a - t * ab).norm();
}

double TriangleDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                        const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const bool above = normal.dot((b - a).cross(p - a)) >= 0 &&
                     normal.dot((c - b).cross(p - b)) >= 0 && normal.dot((a - c).cross(p - c)) >= 0;
  if (above && normal.norm() > 0) return std::abs(normal.dot(p - a)) / normal.norm();
  return std::min({SegmentDistance(p, a, b), SegmentDistance(p, b, c), SegmentDistance(p, c, a)});
}

// Returns the signed solid angle of a triangle seen from the origin. Source: Van Oosterom and
// Strackee, "The solid angle of a plane triangle", 1983.
double SolidAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return 2 * std::atan2(a.dot(b.cross(c)), below);
}

// Returns true if the point is inside or at most `guard` (m) away from the surface. For a point
// inside, the solid angles of all triangles add up to 4 pi; for a point outside, to 0.
bool MeshContains(const TriangleMesh& mesh, const Eigen::Vector3d& p, double guard) {
  double angle = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[static_cast<std::size_t>(triangle[0])];
    const Eigen::Vector3d& b = mesh.vertices[static_cast<std::size_t>(triangle[1])];
    const Eigen::Vector3d& c = mesh.vertices[static_cast<std::size_t>(triangle[2])];
    if (TriangleDistance(p, a, b, c) <= guard) return true;
    angle += SolidAngle(a - p, b - p, c - p);
  }
  return angle > 2 * M_PI;
}

double LargestSize(const Shape& shape) {
  if (shape.type != GeomType::kMesh) return shape.size.cwiseAbs().maxCoeff();
  double largest = 0;
  for (const Eigen::Vector3d& vertex : shape.mesh->vertices) {
    largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

bool Contains(const Shape& shape, const Pose& X_AG, const Eigen::Vector3d& p_A) {
  // Points farther away are outside of every shape; products of their coordinates would overflow.
  constexpr double kFar = 1e100;
  if (p_A.cwiseAbs().maxCoeff() > kFar) return false;
  const Eigen::Vector3d p = X_AG.q.conjugate() * (p_A - X_AG.p);
  const double guard = kDoubleRounding * (LargestSize(shape) + X_AG.p.norm() + p_A.norm());
  const Eigen::Vector3d& s = shape.size;
  switch (shape.type) {
    case GeomType::kSphere:
      return p.norm() <= s.x() + guard;
    case GeomType::kCapsule: {
      const double beyond = std::max(std::abs(p.z()) - s.y(), 0.0);
      return std::hypot(p.x(), p.y(), beyond) <= s.x() + guard;
    }
    case GeomType::kEllipsoid:
      return p.cwiseQuotient(s).norm() <= 1 + guard / s.minCoeff();
    case GeomType::kCylinder:
      return std::abs(p.z()) <= s.y() + guard && std::hypot(p.x(), p.y()) <= s.x() + guard;
    case GeomType::kBox:
      return (p.cwiseAbs() - s).maxCoeff() <= guard;
    case GeomType::kMesh:
      return MeshContains(*shape.mesh, p, guard);
  }
  return false;
}

bool Contains(const Object& object, const Eigen::Vector3d& p_W) {
  const std::vector<Pose> X_WB = BodyPoses(object);
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const Eigen::Vector3d p_B = X_WB[i].Inverse() * p_W;
    for (const Part& part : object.bodies[i].parts) {
      if (part.role != Role::kVisual && Contains(part.shape, part.X_BG, p_B)) return true;
    }
  }
  return false;
}

}  // namespace mjforge::model
