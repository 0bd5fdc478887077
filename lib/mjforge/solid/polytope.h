#pragma once

// Convex polyhedra, and what is within a distance of them.

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

/// Their convex hull, by Qhull, which joins the facets of one plane. Nothing, and a fault, if it
/// has no volume.
std::optional<Polytope> HullOf(std::span<const Eigen::Vector3d> points, Fault& fault);

/// Of the half sizes.
Polytope BoxOf(const Eigen::Vector3d& half);

Piece PieceOf(const Polytope& polytope);

/// The surface at the distance `radius` > 0: `per_turn` segments for a turn of the normal.
Surface RoundedSurface(const Polytope& polytope, double radius, int per_turn);

/// Of all that is within `radius` >= 0.
Mass RoundedMass(const Polytope& polytope, double radius);

}  // namespace mjforge::solid
