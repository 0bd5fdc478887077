// Distances between convex shapes, and of points from the convex hull of several shapes, by the GJK
// algorithm; penetration depths by the EPA algorithm of libccd. A mesh counts as its convex hull.
// All shapes of a call must have poses in the same frame W. Points and vectors are in W, too.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "mjforge/model/model.h"

namespace mjforge::distance {

/// A shape whose frame G has the pose X_WG in some frame W.
struct PlacedShape {
  PlacedShape(const model::Shape& of, const model::Pose& at);

  model::Shape shape;
  model::Pose X_WG;
  Eigen::Matrix3d R_WG;       // rotation of X_WG
  Eigen::AlignedBox3d box_W;  // bounding box
};

/// Returns the bounding box of all shapes.
Eigen::AlignedBox3d BoxAround(std::span<const PlacedShape> shapes);

/// Returns a point of the shape, in W, that is farthest in a direction of any length.
Eigen::Vector3d FarthestPoint(const PlacedShape& placed, const Eigen::Vector3d& direction_W);

/// Returns the vector, in W, from the nearest point of B to the nearest point of A, m; zero if the
/// shapes overlap.
Eigen::Vector3d Separation(const PlacedShape& a, const PlacedShape& b);

/// Returns the distance of two shapes, m; 0 if the shapes overlap.
double Distance(const PlacedShape& a, const PlacedShape& b);

/// Returns the distance of two shapes, m, if it is at most `limit`; otherwise a number between
/// `limit` and the largest distance between points of the shapes. Takes a fraction of the time of
/// Distance().
double DistanceUpTo(double limit, const PlacedShape& a, const PlacedShape& b);

/// Returns the distance of two shapes, m; if the shapes overlap, minus the penetration depth, which
/// is the length of the shortest translation that separates them. The error of the depth is at most
/// a ten-thousandth of the shapes' size.
double SignedDistance(const PlacedShape& a, const PlacedShape& b);

/// Returns the vector, in W, from the nearest point of the shapes' convex hull to the point `p_W`,
/// m; zero if the hull contains the point. There must be at least one shape.
Eigen::Vector3d FromHull(std::span<const PlacedShape> shapes, const Eigen::Vector3d& p_W);

}  // namespace mjforge::distance
