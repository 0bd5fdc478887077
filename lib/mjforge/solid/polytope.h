// Convex polyhedra: boxes, flat hulls, triangulation, and Minkowski sums with a ball (polyhedra
// with rounded edges).

#pragma once

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {

/// Returns a box centred on the origin.
Polytope BoxOf(const Eigen::Vector3d& half_sizes);

/// The hull of points in a plane as a prism of height 0: two faces, and sides with normals but
/// without area. Vertices of both faces coincide.
struct FlatHull {
  Polytope core;
  /// If all points are on a line: both ends of the hull, which are equal if all points are equal.
  std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> line;
};
/// Returns the flat hull of at least one point. Points beside the hull's plane are projected onto
/// this plane.
FlatHull FlatHullOf(std::span<const Eigen::Vector3d> points);

/// Merges vertices with equal position and normal, and removes triangles that lose their area. The
/// mesh must not have texture coordinates.
void RemoveRepeats(TriangleMesh& mesh);

/// Returns the faces of a polytope as triangles, without normals. Faces share their vertices.
TriangleMesh MeshOf(const Polytope& polytope);

/// Returns a sphere, capsule or cylinder at the middle of two points, with its z axis from `a` to
/// `b`. `size` is in the convention of MuJoCo's geoms.
ConvexPiece Primitive(ConvexPiece::Type type, const Eigen::Vector3d& size, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b);

/// Returns the angle between two unit vectors, rad.
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Returns the surface at the distance `radius` > 0 from the polytope, with normals. Arcs have
/// `per_turn` segments in a whole turn.
TriangleMesh RoundedMesh(const Polytope& polytope, double radius, int per_turn);

/// Returns the mass of the polytope enlarged by the distance `radius` >= 0, m (Minkowski sum with a
/// ball), as the sum of the polytope, slabs on its faces, sectors of cylinders along its edges and
/// sectors of balls at its vertices.
Mass RoundedMass(const Polytope& polytope, double radius);

}  // namespace mjforge::solid
