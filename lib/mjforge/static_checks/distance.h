// Distances of convex parts and of their convex hulls. Meshes count as their convex hulls.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "mjforge/model/model.h"

namespace mjforge::static_checks {

/// A part whose frame G has the pose X_WG in some frame W.
struct PlacedPart {
  PlacedPart(const model::Part* of, const model::Pose& at);

  const model::Part* part;
  model::Pose X_WG;
  Eigen::AlignedBox3d box_W;  // bounding box
};

/// Returns a point of the part that is farthest in a direction.
Eigen::Vector3d FarthestPoint(const PlacedPart& part, const Eigen::Vector3d& direction_W);

/// Distance of two parts, m; 0 if they overlap.
double Distance(const PlacedPart& a, const PlacedPart& b);

/// Distance of two parts, m. If they overlap, minus the penetration depth: the shortest translation
/// that separates them, to a ten-thousandth of their size.
double SignedDistance(const PlacedPart& a, const PlacedPart& b);

/// Vector to a point from the nearest point of the parts' convex hull, m; zero if the hull contains
/// the point.
Eigen::Vector3d FromHull(std::span<const PlacedPart> parts, const Eigen::Vector3d& p_W);

}  // namespace mjforge::static_checks
