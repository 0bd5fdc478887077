#pragma once

// Solids, measured.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "mjforge/solid/solid.h"

#include "harness/random.h"

namespace mjforge::solid {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

inline constexpr double kPi = std::numbers::pi;

using harness::Random;

/// Nodes and weights of Gauss and Legendre on 0 .. 1, by Newton's method.
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

inline bool ContainsPrimitive(const Piece& piece, const Vector3d& q) {
  const double r = piece.size.x();
  const double beyond = std::abs(q.z()) - piece.size.y();
  switch (piece.type) {
    case Piece::Type::kSphere:
      return q.norm() <= r;
    case Piece::Type::kCylinder:
      return q.head<2>().norm() <= r && beyond <= 0;
    case Piece::Type::kCapsule:
      return Vector3d(q.x(), q.y(), std::max(beyond, 0.0)).norm() <= r;
    default:
      return (q.cwiseAbs() - piece.size).maxCoeff() <= 0;
  }
}

inline bool Contains(const Piece& piece, const Vector3d& p) {
  if (piece.type != Piece::Type::kMesh)
    return ContainsPrimitive(piece, piece.q.conjugate() * (p - piece.p));
  return std::ranges::any_of(piece.turns, [&](double turn) {
    const Vector3d q = Eigen::AngleAxisd(-turn, Vector3d::UnitZ()) * p;
    return std::ranges::all_of(piece.triangles, [&](const std::array<int, 3>& corners) {
      const Vector3d& a = piece.vertices[std::size_t(corners[0])];
      const Vector3d normal = (piece.vertices[std::size_t(corners[1])] - a)
                                  .cross(piece.vertices[std::size_t(corners[2])] - a);
      return normal.dot(q - a) <= 0;
    });
  });
}

inline bool ContainsAny(const Solid& solid, const Vector3d& p) {
  return std::ranges::any_of(solid.pieces, [&](const Piece& piece) { return Contains(piece, p); });
}

/// Of what triangles enclose: its mass as that of tetrahedra from the origin.
inline Mass Enclosed(const std::vector<Vector3d>& vertices,
                     const std::vector<std::array<int, 3>>& triangles) {
  Mass mass;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (const std::array<int, 3>& t : triangles) {
    const Vector3d& a = vertices[std::size_t(t[0])];
    const Vector3d& b = vertices[std::size_t(t[1])];
    const Vector3d& c = vertices[std::size_t(t[2])];
    const double six = a.dot(b.cross(c));
    mass.volume += six / 6;
    first += six / 24 * (a + b + c);
    // Exact for squares: -1 / 20 of the volume at each corner, 1 / 5 in the middle of each edge.
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

/// Whether triangles enclose the point: the solid angles that they take of what is seen from it.
inline bool Encloses(const Surface& surface, const Vector3d& p) {
  double angle = 0;
  for (const std::array<int, 3>& t : surface.triangles) {
    const Vector3d a = (surface.vertices[std::size_t(t[0])] - p).normalized();
    const Vector3d b = (surface.vertices[std::size_t(t[1])] - p).normalized();
    const Vector3d c = (surface.vertices[std::size_t(t[2])] - p).normalized();
    angle += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return angle > 2 * kPi;
}

inline double VolumeOf(const std::vector<Vector3d>& vertices,
                       const std::vector<std::array<int, 3>>& triangles) {
  return Enclosed(vertices, triangles).volume;
}

/// The largest difference, relative to the whole.
inline double Difference(const Mass& a, const Mass& b) {
  const double size = std::cbrt(b.volume);
  return std::max({std::abs(a.volume / b.volume - 1), (a.center - b.center).norm() / size,
                   (a.inertia - b.inertia).norm() / b.inertia.norm()});
}

}  // namespace mjforge::solid
