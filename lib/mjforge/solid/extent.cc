// Support functions of the convex hulls of solids.

#include "mjforge/solid/extent.h"

#include <cmath>
#include <limits>

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

/// Returns true if the point of an ellipse that is farthest in a direction is on the arc. `x` and
/// `y` are the dot products of the direction with u and v.
bool IsOnArc(const ExtentCurve& curve, double x, double y) {
  if (curve.is_whole()) return true;
  const double turn = std::atan2(y, x);
  return (turn < 0 ? turn + 2 * std::numbers::pi : turn) <= curve.angle;
}

}  // namespace

double Support(const Extent& extent, const Vector3d& direction) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const ExtentCurve& curve : extent) {
    const double x = curve.u.dot(direction);
    const double y = curve.v.dot(direction);
    const double across = curve.round > 0 ? curve.round * direction.norm() : 0;
    const double reach = curve.center.dot(direction) + Eigen::Vector2d(x, y).norm() + across;
    // Calls IsOnArc(), which takes most of the time, only for points that are farther than the
    // result so far.
    if (reach > largest && IsOnArc(curve, x, y)) largest = reach;
  }
  return largest;
}

void AddLevelArc(const Vector3d& center, double radius, double from, double angle, Extent& extent) {
  if (radius == 0) {
    extent.push_back({.center = center});
    return;
  }
  const auto at = [radius](double turn) {
    return Vector3d(radius * std::cos(turn), radius * std::sin(turn), 0);
  };
  const Vector3d u = at(from);
  const ExtentCurve& arc = extent.emplace_back(ExtentCurve{center, u, {-u.y(), u.x(), 0}, angle});
  if (arc.is_whole()) return;
  extent.push_back({.center = center + u});
  extent.push_back({.center = center + at(from + angle)});
}

Extent ExtentOf(std::span<const Vector3d> points, double round) {
  Extent extent;
  for (const Vector3d& p : points) extent.push_back({.center = p, .round = round});
  return extent;
}

}  // namespace mjforge::solid
