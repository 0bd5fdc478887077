// Boxes as convex polyhedra, and the solids at a distance around them (Minkowski sums with a ball).

#pragma once

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {

/// Returns a box centred on the origin.
Polytope BoxOf(const Eigen::Vector3d& half_sizes);

TriangleMesh MeshOf(const Polytope& polytope);

/// Returns the angle between two unit vectors, rad.
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Returns the surface at the distance `radius` > 0, with normals. Arcs have `per_turn` segments in
/// a whole turn.
TriangleMesh RoundedMesh(const Polytope& polytope, double radius, int per_turn);

/// Returns the mass of all points within the distance `radius` >= 0.
Mass RoundedMass(const Polytope& polytope, double radius);

}  // namespace mjforge::solid
