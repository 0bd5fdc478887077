// Convex polyhedra, and the solids at a distance around them (Minkowski sums with a ball).

#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {

struct Polytope {
  struct Face {
    std::vector<int> corners;  // counter-clockwise from outside
    Eigen::Vector3d normal;    // outward, of length 1
  };
  std::vector<Eigen::Vector3d> vertices;
  std::vector<Face> faces;
};

/// Returns the convex hull, computed by Qhull, which merges coplanar facets. The order of faces and
/// vertices depends only on the order of the points. Returns nothing and sets `fault` if the hull
/// has no volume.
std::optional<Polytope> HullOf(std::span<const Eigen::Vector3d> points, Fault& fault);

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
