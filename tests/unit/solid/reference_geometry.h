// Reference computations for tests of solids: quadrature, containment, enclosed mass.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "mjforge/solid/solid.h"

#include "harness/random.h"

namespace mjforge::solid {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

inline constexpr double kPi = std::numbers::pi;

using harness::Random;

template <typename Shape>
Solid Made(const Shape& shape) {
  Fault fault;
  std::optional<Solid> solid = Make(shape, fault);
  INFO(fault.message);
  REQUIRE(solid);
  return *std::move(solid);
}

/// Returns nodes and weights of Gauss-Legendre quadrature on 0 .. 1, found by Newton's method.
inline std::vector<std::pair<double, double>> Gauss(int count) {
  std::vector<std::pair<double, double>> nodes;
  for (int i = 0; i < count; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (count + 0.5));
    double slope = 0;
    for (int k = 0; k < 50; ++k) {
      double p = 1;
      double before = 0;
      for (int j = 1; j <= count; ++j)
        before = std::exchange(p, ((2 * j - 1) * x * p - (j - 1) * before) / j);
      slope = count * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    nodes.emplace_back((1 + x) / 2, 1 / ((1 - x * x) * slope * slope));
  }
  return nodes;
}

inline bool Contains(const std::vector<Vector2d>& outline, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Vector2d& a = outline[i];
    const Vector2d& b = outline[j];
    if ((a.y() > y) != (b.y() > y) && x < (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()) + a.x())
      inside = !inside;
  }
  return inside;
}

inline bool ContainsPrimitive(const ConvexPiece& piece, const Vector3d& q) {
  const double r = piece.size.x();
  const double beyond = std::abs(q.z()) - piece.size.y();
  switch (piece.type) {
    case ConvexPiece::Type::kSphere:
      return q.norm() <= r;
    case ConvexPiece::Type::kCylinder:
      return q.head<2>().norm() <= r && beyond <= 0;
    case ConvexPiece::Type::kCapsule:
      return Vector3d(q.x(), q.y(), std::max(beyond, 0.0)).norm() <= r;
    default:
      return (q.cwiseAbs() - piece.size).maxCoeff() <= 0;
  }
}

inline bool Contains(const ConvexPiece& piece, const Vector3d& p) {
  if (piece.type != ConvexPiece::Type::kMesh)
    return ContainsPrimitive(piece, piece.q.conjugate() * (p - piece.p));
  return std::ranges::any_of(piece.turns, [&](double turn) {
    const Vector3d q = Eigen::AngleAxisd(-turn, Vector3d::UnitZ()) * p;
    return std::ranges::all_of(piece.mesh.triangles, [&](const std::array<int, 3>& corners) {
      const Vector3d& a = piece.mesh.vertices[std::size_t(corners[0])];
      const Vector3d normal = (piece.mesh.vertices[std::size_t(corners[1])] - a)
                                  .cross(piece.mesh.vertices[std::size_t(corners[2])] - a);
      return normal.dot(q - a) <= 0;
    });
  });
}

inline bool ContainsAny(const Solid& solid, const Vector3d& p) {
  return std::ranges::any_of(solid.pieces,
                             [&](const ConvexPiece& piece) { return Contains(piece, p); });
}

/// Returns the mass enclosed by a mesh, as the sum of tetrahedra from the origin.
inline Mass Enclosed(const TriangleMesh& mesh) {
  Mass mass;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vector3d& a = mesh.vertices[std::size_t(t[0])];
    const Vector3d& b = mesh.vertices[std::size_t(t[1])];
    const Vector3d& c = mesh.vertices[std::size_t(t[2])];
    const double six = a.dot(b.cross(c));
    mass.volume += six / 6;
    first += six / 24 * (a + b + c);
    // Exact for quadratic functions: weights -1 / 20 at each corner, 1 / 5 at each edge's middle.
    for (const Vector3d& p : {a, b, c}) second -= six / 120 * p * p.transpose();
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      second += six / 6 / 5 * (p + q) / 2 * (p + q).transpose() / 2;
    for (const Vector3d& p : {a, b, c}) second += six / 6 / 5 * p / 2 * p.transpose() / 2;
  }
  mass.center = first / mass.volume;
  second -= mass.volume * mass.center * mass.center.transpose();
  mass.inertia = second.trace() * Matrix3d::Identity() - second;
  return mass;
}

/// Returns true if the mesh encloses the point, by the sum of the solid angles of its triangles.
inline bool Encloses(const TriangleMesh& mesh, const Vector3d& p) {
  double angle = 0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vector3d a = (mesh.vertices[std::size_t(t[0])] - p).normalized();
    const Vector3d b = (mesh.vertices[std::size_t(t[1])] - p).normalized();
    const Vector3d c = (mesh.vertices[std::size_t(t[2])] - p).normalized();
    angle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return angle > 2 * kPi;
}

inline double VolumeOf(const TriangleMesh& mesh) { return Enclosed(mesh).volume; }

/// Returns the largest relative difference of volume, centre and inertia.
inline double Difference(const Mass& a, const Mass& b) {
  const double size = std::cbrt(b.volume);
  return std::max({std::abs(a.volume / b.volume - 1), (a.center - b.center).norm() / size,
                   (a.inertia - b.inertia).norm() / b.inertia.norm()});
}

}  // namespace mjforge::solid
