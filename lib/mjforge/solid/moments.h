// Mass moments of areas and solids, by Gauss quadrature along their boundaries.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mjforge/solid/rounded_corners.h"

namespace mjforge::solid {

/// Quadrature node on the boundary of an area, for integrals over y: a function's value at `p` has
/// the weight `dy`. Exact for polynomials up to degree 5 along lines, and up to rounding errors
/// along arcs.
struct QuadratureNode {
  Point2 p;
  double dy = 0;
};
std::vector<QuadratureNode> NodesOf(std::span<const Point2> outline);

/// Number of quadrature nodes along an arc.
inline constexpr std::size_t kArcNodes = 30;
/// Unit vectors from the centre of an arc to its quadrature nodes, then to its two ends. Arcs that
/// differ only in centre and radius have the same unit vectors.
using ArcDirections = std::array<Point2, kArcNodes + 2>;
/// Returns the unit vectors of the arc at each corner; those of a sharp corner are undefined.
std::vector<ArcDirections> DirectionsOf(const std::vector<RoundedCorner>& corners);
std::vector<QuadratureNode> NodesOf(const std::vector<RoundedCorner>& corners,
                                    const std::vector<ArcDirections>& directions);

/// Returns the mass of the solid that an outline in r, z sweeps when it is revolved about z from
/// angle 0 to `angle`, rad. Applies the theorem of Pappus and Guldinus to all moments up to the
/// second.
Mass RevolvedMass(std::span<const QuadratureNode> boundary, double angle);

/// Moments of a solid of density 1 about a point.
struct Moments {
  double volume = 0;
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T
};
/// Returns the mass properties of the solid that has these moments about `origin`.
Mass MassOf(const Moments& moments, const Eigen::Vector3d& origin);

/// Integrals of 1, x, y and their products over a plane area.
struct AreaMoments {
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
};
AreaMoments MomentsOf(std::span<const QuadratureNode> boundary);

}  // namespace mjforge::solid
