// Convex hulls of exact solids, described by curves, and their support functions.

#pragma once

#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Dense>

namespace mjforge::solid {

/// Arc of an ellipse: the points center + cos(t) u + sin(t) v for t from 0 to `angle`, enlarged by
/// a ball of radius `round` about each point. In a whole ellipse, u is perpendicular to v. If u and
/// v are zero, the curve is a point. An arc does not include its ends, which are separate curves.
struct ExtentCurve {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // m
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  double angle = 2 * std::numbers::pi;  // rad
  double round = 0;                     // m
  bool is_whole() const { return angle == 2 * std::numbers::pi; }
};

/// Curves whose convex hull is the convex hull of the solid.
using Extent = std::vector<ExtentCurve>;

/// Returns the support function: the largest dot(direction, point), or minus infinity if `extent`
/// is empty. The direction may have any length.
double Support(const Extent& extent, const Eigen::Vector3d& direction);

/// Adds a horizontal circular arc about `center`, from the angle `from` to from + angle, rad, and
/// the ends of the arc.
void AddLevelArc(const Eigen::Vector3d& center, double radius, double from, double angle,
                 Extent& extent);

/// Returns the extent of balls of radius `round`, m, about the points.
Extent ExtentOf(std::span<const Eigen::Vector3d> points, double round);

}  // namespace mjforge::solid
