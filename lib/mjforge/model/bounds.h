// Bounds of an object at its start and at all positions of its joints.

#pragma once

#include <Eigen/Dense>

#include "mjforge/model/shapes.h"

namespace mjforge::model {

/// Extents of the collision parts (of all parts if none collides) at the start state, in the
/// object's frame W; see BodyPoses(). Solids have their exact extents, not those of their pieces.
struct Bounds {
  Box3 aabb;
  double top_offset = 0;         // aabb.max.z, m
  double bottom_offset = 0;      // aabb.min.z, m
  double horizontal_radius = 0;  // largest distance from the z axis of W, m
  bool declared = false;         // given by `total_size`, not computed
  Box3 swept;                    // over the ranges of the joints; see SweptBounds()
  Eigen::Vector3d half_size() const { return (aabb.max - aabb.min) / 2; }
};

}  // namespace mjforge::model
