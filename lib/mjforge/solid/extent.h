// Convex hulls of true solids, as curves that support functions are computed from.

#pragma once

#include <numbers>
#include <span>
#include <vector>

#include <Eigen/Dense>

namespace mjforge::solid {

/// The points center + cos(t) u + sin(t) v for t from 0 to `angle`, and all that is within `round`
/// of them across the curve. An ellipse is a whole turn with u perpendicular to v, a point has both
/// zero. The ends of an arc are not part of it, and are curves of their own.
struct ExtentCurve {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // m
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  double angle = 2 * std::numbers::pi;  // rad
  double round = 0;                     // m
  bool is_whole() const { return angle == 2 * std::numbers::pi; }
};

/// The convex hull of the curves is that of the solid.
using Extent = std::vector<ExtentCurve>;

/// Support function: the largest dot(direction, point). The direction has any length.
double Support(const Extent& extent, const Eigen::Vector3d& direction);

/// Adds the arc of a circle about an axis along z, and its ends: `radius` away from `center`, from
/// the angle `from` to from + angle.
void AddLevelArc(const Eigen::Vector3d& center, double radius, double from, double angle,
                 Extent& extent);

/// Returns the points, enlarged by `round`, m.
Extent ExtentOf(std::span<const Eigen::Vector3d> points, double round);

}  // namespace mjforge::solid
