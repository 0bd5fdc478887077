// Mass moments of areas and solids, by Gauss quadrature along their boundaries.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mjforge/solid/rounded_corners.h"

namespace mjforge::solid {

/// Quadrature node on the boundary of an area, for integrals over y: a function's value at `p` has
/// the weight `dy`, m. Such integrals give the moments of the area (Green's theorem); the area is
/// the integral of x. Exact for polynomials up to degree 5 along lines, and up to rounding errors
/// along arcs.
struct QuadratureNode {
  Point2 p;
  double dy = 0;
};
/// Returns the nodes of the sides of a closed outline.
std::vector<QuadratureNode> NodesOf(std::span<const Point2> outline);

/// Number of quadrature nodes along an arc.
inline constexpr std::size_t kArcNodes = 30;
/// Unit vectors from the centre of an arc to its quadrature nodes, then to its two ends. Arcs that
/// differ only in centre and radius have the same unit vectors.
using ArcDirections = std::array<Point2, kArcNodes + 2>;
/// Returns the unit vectors of the arc at each corner; those of a sharp corner are undefined.
std::vector<ArcDirections> DirectionsOf(const std::vector<RoundedCorner>& corners);
/// Returns the nodes of the arcs and sides of a closed outline with rounded corners. `directions`
/// is the result of DirectionsOf() for corners with the same arcs, of any centre and radius.
std::vector<QuadratureNode> NodesOf(const std::vector<RoundedCorner>& corners,
                                    const std::vector<ArcDirections>& directions);

/// Returns the mass of the solid that an outline in r, z sweeps when it is revolved about z from
/// angle 0 to `angle`, rad. Applies the theorem of Pappus and Guldinus to all moments up to the
/// second.
Mass RevolvedMass(std::span<const QuadratureNode> boundary, double angle);

/// Moments of a solid of density 1 about a point.
struct Moments {
  double volume = 0;                                 // m^3
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   // integral of x, m^4
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T, m^5
};
/// Returns the mass properties of the solid that has these moments about `origin`.
Mass MassOf(const Moments& moments, const Eigen::Vector3d& origin);

/// Integrals of 1, x, y and their products over a plane area.
struct AreaMoments {
  double area = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
};
/// Returns the moments of the area inside a boundary, whose outline is counter-clockwise and whose
/// holes are clockwise, by Green's theorem.
AreaMoments MomentsOf(std::span<const QuadratureNode> boundary);

}  // namespace mjforge::solid
