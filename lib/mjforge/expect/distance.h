#pragma once

// Private to the room: distances of convex solids.

#include <span>

#include <Eigen/Geometry>

#include "mjforge/model/model.h"

namespace mjforge::expect {

/// A shape somewhere in the world W.
struct Solid {
  Solid(const model::Part* of, const model::Pose& at);

  const model::Part* part;
  model::Pose X_WG;
  Eigen::AlignedBox3d box_W;  // around it
};

/// A point of the solid that is farthest in a direction.
Eigen::Vector3d FarthestPoint(const Solid& solid, const Eigen::Vector3d& direction_W);
/// The same of the convex hull of several.
Eigen::Vector3d FarthestPoint(std::span<const Solid> solids, const Eigen::Vector3d& direction_W);

/// The distance of two solids, m. Where they overlap it is less than 0, the shortest way that takes
/// one out of the other, to a ten-thousandth of their size.
double SignedDistance(const Solid& a, const Solid& b);

/// From the nearest point of the solids' convex hull to a point; zero if the point is in it. m.
Eigen::Vector3d FromHull(std::span<const Solid> solids, const Eigen::Vector3d& p_W);

}  // namespace mjforge::expect
