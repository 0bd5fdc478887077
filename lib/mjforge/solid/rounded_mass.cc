// Exact mass of the Minkowski sum of a polytope and a ball.

#include <cmath>
#include <numbers>

#include "mjforge/solid/half_edges.h"
#include "mjforge/solid/moments.h"

namespace mjforge::solid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Adds the moments of the tetrahedron p a b c: integrals of 1, x and x x^T over the simplex.
void AddTetrahedron(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c,
                    Moments& sum) {
  const double six = (a - p).dot((b - p).cross(c - p));
  const Vector3d total = p + a + b + c;
  sum.volume += six / 6;
  sum.first += six / 24 * total;
  sum.second += six / 120 *
                (total * total.transpose() + p * p.transpose() + a * a.transpose() +
                 b * b.transpose() + c * c.transpose());
}

/// Adds the moments of a triangle extruded by the vector `up`.
void AddSlab(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& up,
             Moments& sum) {
  AddTetrahedron(a, b, c, c + up, sum);
  AddTetrahedron(a, b, c + up, b + up, sum);
  AddTetrahedron(a, b + up, c + up, a + up, sum);
}

/// Adds the moments of the sector of a cylinder about the edge ab, between the unit vectors m and
/// n.
void AddSector(const Vector3d& a, const Vector3d& b, const Vector3d& m, const Vector3d& n, double r,
               Moments& sum) {
  const Vector3d edge = b - a;
  const double length = edge.norm();
  if (length == 0) return;
  const double angle = AngleBetween(m, n);
  const Vector3d middle = (m + n).normalized();
  const Vector3d across = edge.cross(middle) / length;
  const Vector3d c = (a + b) / 2;
  const double area = r * r * angle / 2;
  const Vector3d first = r * r * r / 3 * 2 * std::sin(angle / 2) * middle;
  const Matrix3d second = r * r * r * r / 4 *
                          ((angle + std::sin(angle)) / 2 * middle * middle.transpose() +
                           (angle - std::sin(angle)) / 2 * across * across.transpose());
  sum.volume += area * length;
  sum.first += length * (area * c + first);
  sum.second += length * (area * c * c.transpose() + area / 12 * edge * edge.transpose() +
                          c * first.transpose() + first * c.transpose() + second);
}

/// Adds the moments of the part of a ball at a vertex: the cone with apex v over the spherical
/// polygon of the normals. The integral of 1 over the spherical polygon is the solid angle of its
/// triangles (Van Oosterom and Strackee, 1983); the integrals of n and n n^T follow from the
/// divergence theorem on the sphere, along the polygon's great arcs.
void AddCone(const Vector3d& v, const std::vector<Vector3d>& normals, double r, Moments& sum) {
  double solid_angle = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d boundary = Matrix3d::Zero();
  const std::size_t count = normals.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3d& a = normals[i];
    const Vector3d& b = normals[(i + 1) % count];
    const Vector3d& start = normals[0];
    const double triple = start.dot(a.cross(b));
    solid_angle += 2 * std::atan2(triple, 1 + start.dot(a) + a.dot(b) + b.dot(start));
    const Vector3d axis = a.cross(b);
    if (!(axis.norm() > 0)) continue;
    const double angle = AngleBetween(a, b);
    const Vector3d pole = axis.normalized();
    first += angle / 2 * pole;
    boundary += std::tan(angle / 2) * (a + b) * pole.transpose();
  }
  Matrix3d second = (solid_angle * Matrix3d::Identity() + boundary) / 3;
  second = (second + second.transpose()).eval() / 2;
  const double volume = r * r * r / 3 * solid_angle;
  const Vector3d along = r * r * r * r / 4 * first;
  sum.volume += volume;
  sum.first += volume * v + along;
  sum.second += volume * v * v.transpose() + v * along.transpose() + along * v.transpose() +
                std::pow(r, 5) / 5 * second;
}

}  // namespace

// The Minkowski sum of a polytope and a ball consists of the polytope, slabs on its faces, sectors
// of cylinders along its edges and sectors of balls at its vertices.
Mass RoundedMass(const Polytope& polytope, double radius) {
  Vector3d origin = Vector3d::Zero();  // inside the polytope, to reduce cancellation
  for (const Vector3d& p : polytope.vertices)
    origin += p / static_cast<double>(polytope.vertices.size());
  const auto at = [&](int i) {
    return Vector3d(polytope.vertices[static_cast<std::size_t>(i)] - origin);
  };
  Moments sum;
  for (const Polytope::Face& face : polytope.faces) {
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
      const Vector3d a = at(face.corners[0]);
      const Vector3d b = at(face.corners[i]);
      const Vector3d c = at(face.corners[i + 1]);
      AddTetrahedron(Vector3d::Zero(), a, b, c, sum);
      if (radius > 0) AddSlab(a, b, c, radius * face.normal, sum);
    }
  }
  if (!(radius > 0)) return MassOf(sum, origin);
  const auto normal = [&](int face) {
    return polytope.faces[static_cast<std::size_t>(face)].normal;
  };
  const HalfEdges edges(polytope);
  for (const auto& [a, b] : edges.All())
    AddSector(at(a), at(b), normal(edges.FaceAt(a, b)), normal(edges.FaceAt(b, a)), radius, sum);
  for (std::size_t i = 0; i < polytope.vertices.size(); ++i) {
    std::vector<Vector3d> normals;
    for (const int face : edges.FacesAround(static_cast<int>(i))) normals.push_back(normal(face));
    AddCone(at(static_cast<int>(i)), normals, radius, sum);
  }
  return MassOf(sum, origin);
}

}  // namespace mjforge::solid
