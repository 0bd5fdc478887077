// Bounds of an object at its start and at all positions of its joints.

#pragma once

#include <Eigen/Dense>

#include "mjforge/model/shapes.h"

namespace mjforge::model {

/// Bounds of the collision parts (of all parts if none collides) at the start state, in the
/// object's frame W; see BodyPoses(). A solid that consists of convex pieces contributes its exact
/// extent, not the extents of the pieces.
struct Bounds {
  Box3 aabb;
  double top_offset = 0;         // aabb.max.z, m
  double bottom_offset = 0;      // aabb.min.z, m
  double horizontal_radius = 0;  // largest distance from the z axis of W, m
  bool declared = false;         // true if `total_size` of the spec replaces the computed bounds
  Box3 swept;                    // contains the parts at all joint positions; see SweptBounds()
  Eigen::Vector3d half_size() const { return (aabb.max - aabb.min) / 2; }
};

}  // namespace mjforge::model
