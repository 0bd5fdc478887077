// Rotation-minimizing frames along the path of a tube.

#pragma once

#include <vector>

#include "mjforge/solid/sweep_path.h"

namespace mjforge::solid {

/// A point of the path, with directions along and across the path. Two frames share the point at
/// which one segment ends and the next begins.
struct SweepFrame {
  Eigen::Vector3d p;
  Eigen::Vector3d tangent;  // unit vector
  Eigen::Vector3d x;        // unit vector across the path
  Eigen::Vector3d cut;  // normal of the plane that cuts the tube: differs from `tangent` at corners
  double radius = 0;
  double slope = 0;       // change of the radius per length
  double arc_length = 0;  // from the path's start, along its chords, m
  Eigen::Vector3d y() const { return tangent.cross(x); }
};

/// Returns frames at both ends of each segment and, in arcs and cubic segments, between the ends:
/// `per_turn` in a whole turn of an arc or in four cubic segments. The frames rotate as little as
/// possible about the path; on a closed path the last frame equals the first. Source: Wang,
/// Juettler, Zheng and Liu, "Computation of rotation minimizing frames", 2008.
std::vector<SweepFrame> SweepFramesOf(const std::vector<PathSegment>& segments, bool closed,
                                      int per_turn);

}  // namespace mjforge::solid
