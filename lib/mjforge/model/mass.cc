// Volume, mass, centre of mass and inertia of shapes.

#include <cmath>

#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

// Returns the principal moments of inertia of a capsule of mass 1 about its centre. The capsule
// consists of a cylinder and two hemispheres, whose centroids are at 3/8 r from their faces.
// Source: Goldstein, "Classical Mechanics", 3rd ed., ch. 5.
Eigen::Vector3d CapsuleInertia(double radius, double half_length) {
  const double height = 2 * half_length;
  // Fraction of the mass in the hemispheres.
  const double spheres = 4 * radius / (4 * radius + 3 * height);
  const double cylinder = 1 - spheres;
  const double r2 = radius * radius;
  const double across = cylinder * (3 * r2 + height * height) / 12 +
                        spheres * (2 * r2 / 5 + height * (3 * radius + 2 * height) / 8);
  return {across, across, cylinder * r2 / 2 + spheres * 2 * r2 / 5};
}

// Returns the principal moments of inertia of a solid of mass 1 about its centre. Source:
// Goldstein.
Eigen::Vector3d UnitInertia(const Shape& shape) {
  const Eigen::Vector3d& s = shape.size;
  const Eigen::Vector3d s2 = s.cwiseProduct(s);
  switch (shape.type) {
    case GeomType::kSphere:
      return Eigen::Vector3d::Constant(0.4 * s2.x());
    case GeomType::kCapsule:
      return CapsuleInertia(s.x(), s.y());
    case GeomType::kEllipsoid:
      return Eigen::Vector3d(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y()) / 5;
    case GeomType::kCylinder: {
      const double across = (3 * s2.x() + 4 * s2.y()) / 12;
      return {across, across, s2.x() / 2};
    }
    case GeomType::kBox:
      return Eigen::Vector3d(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y()) / 3;
    case GeomType::kMesh:
      break;
  }
  return Eigen::Vector3d::Zero();
}

// Divisors in the formulas for an element of a mesh: a tetrahedron of a solid (corners 0, a, b, c)
// or a triangle of a shell (corners a, b, c). An element with the weight w and the density 1 has
// the mass w / `mass`, the centre of mass s / `first` with s = a + b + c, and the matrix of second
// moments w / `second` (aa' + bb' + cc' + ss').
struct Divisors {
  double mass = 1;
  double first = 1;
  double second = 1;
};

// Returns the mass properties of a mesh as a sum over all triangles. `weight_of` returns the weight
// of a triangle (see Divisors) from its corners a, b, c, which are relative to the mean vertex M.
template <typename WeightOf>
MassProperties SumOf(const TriangleMesh& mesh, double density, const Divisors& divisors,
                     const WeightOf& weight_of) {
  // Sums over tetrahedra with the apex M have smaller rounding errors than sums with a distant
  // apex.
  const Eigen::Vector3d p_GM = MeanVertex(mesh);
  double weight = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[static_cast<std::size_t>(triangle[0])] - p_GM;
    const Eigen::Vector3d b = mesh.vertices[static_cast<std::size_t>(triangle[1])] - p_GM;
    const Eigen::Vector3d c = mesh.vertices[static_cast<std::size_t>(triangle[2])] - p_GM;
    const double w = weight_of(a, b, c);
    const Eigen::Vector3d s = a + b + c;
    weight += w;
    first += w * s;
    second += w * (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
  }
  MassProperties result;
  if (weight == 0) return result;
  const Eigen::Vector3d p_MCm = first / (divisors.first * weight);
  const Eigen::Matrix3d about_Cm =
      density * (second / divisors.second - weight / divisors.mass * p_MCm * p_MCm.transpose());
  result.mass = density * weight / divisors.mass;
  result.p_FCm = p_GM + p_MCm;
  result.I_Cm_F = about_Cm.trace() * Eigen::Matrix3d::Identity() - about_Cm;
  return result;
}

// Returns the mass properties of a solid: the sum over the tetrahedra that the mean vertex M forms
// with each triangle, whose weights are det(a b c). Source: Tonon, "Explicit exact formulas for the
// 3-D tetrahedron inertia tensor", 2004.
MassProperties MeshMass(const TriangleMesh& mesh, double density) {
  return SumOf(mesh, density, {.mass = 6, .first = 4, .second = 120},
               [](const auto& a, const auto& b, const auto& c) { return a.dot(b.cross(c)); });
}

// Returns the inertia tensor of a point mass at the position `r`.
Eigen::Matrix3d PointInertia(double mass, const Eigen::Vector3d& r) {
  return mass * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
}

}  // namespace

Eigen::Vector3d MeanVertex(const TriangleMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& vertex : mesh.vertices) sum += vertex;
  return mesh.vertices.empty() ? sum : Eigen::Vector3d(sum / double(mesh.vertices.size()));
}

double Volume(const Shape& shape) {
  const Eigen::Vector3d& s = shape.size;
  switch (shape.type) {
    case GeomType::kSphere:
      return 4 * M_PI / 3 * s.x() * s.x() * s.x();
    case GeomType::kCapsule:
      return M_PI * s.x() * s.x() * (2 * s.y() + 4 * s.x() / 3);
    case GeomType::kEllipsoid:
      return 4 * M_PI / 3 * s.prod();
    case GeomType::kCylinder:
      return 2 * M_PI * s.x() * s.x() * s.y();
    case GeomType::kBox:
      return 8 * s.prod();
    case GeomType::kMesh:
      return MeshMass(*shape.mesh, 1).mass;
  }
  return 0;
}

MassProperties MassOf(const Shape& shape, double density) {
  if (shape.type == GeomType::kMesh) return MeshMass(*shape.mesh, density);
  MassProperties result;
  result.mass = density * Volume(shape);
  result.I_Cm_F.diagonal() = result.mass * UnitInertia(shape);
  return result;
}

MassProperties ShellMassOf(const TriangleMesh& mesh) {
  return SumOf(
      mesh, 1, {.mass = 1, .first = 3, .second = 12},
      [](const auto& a, const auto& b, const auto& c) { return (b - a).cross(c - a).norm() / 2; });
}

MassProperties InFrame(const Pose& X_AF, const MassProperties& properties_F) {
  const Eigen::Matrix3d R_AF = X_AF.q.toRotationMatrix();
  return {.mass = properties_F.mass,
          .p_FCm = X_AF * properties_F.p_FCm,
          .I_Cm_F = R_AF * properties_F.I_Cm_F * R_AF.transpose()};
}

MassProperties Combine(const MassProperties& a, const MassProperties& b) {
  MassProperties sum;
  sum.mass = a.mass + b.mass;
  if (sum.mass == 0) return sum;
  sum.p_FCm = (a.mass * a.p_FCm + b.mass * b.p_FCm) / sum.mass;
  sum.I_Cm_F = a.I_Cm_F + PointInertia(a.mass, a.p_FCm - sum.p_FCm) + b.I_Cm_F +
               PointInertia(b.mass, b.p_FCm - sum.p_FCm);
  return sum;
}

MassProperties Scaled(const MassProperties& properties, double factor) {
  return {.mass = properties.mass * factor,
          .p_FCm = properties.p_FCm,
          .I_Cm_F = properties.I_Cm_F * factor};
}

}  // namespace mjforge::model
