#pragma once

// Masses and bounds of bodies, summed up from their parts.

#include <vector>

#include "mjforge/model/assets.h"
#include "mjforge/model/object.h"

namespace mjforge::model {

/// The extents of the parts from `first` on; only of those that collide, if any does.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);
/// Of the body `first` and all that follow, which must be below it, in the frame of `first`, with
/// all joints at zero.
Bounds BoundsFrom(const std::vector<Body>& bodies, std::size_t first);
MassProperties MassFrom(const std::vector<Body>& bodies, std::size_t first);
/// Of a box with these half sizes.
Bounds DeclaredBounds(const Eigen::Vector3d& total_size);

/// Sums up the mass of a body's parts, unless an attached file states it.
void SumMass(Body& body, Assets& assets);
/// Scales the masses of the parts from `first_part` on of one body, and of the bodies from
/// `first_body` on.
void ScaleMass(double factor, std::vector<Body>& bodies, std::size_t body, std::size_t first_part,
               std::size_t first_body);
/// A body with joints that has no mass takes half the mass of the first body fixed to it.
void ShareMass(std::vector<Body>& bodies);
/// X_FB of the bodies from `first`, F, on, with all joints at zero: all below F or, if F is the
/// root, bodies of the world.
std::vector<Pose> PosesFrom(const std::vector<Body>& bodies, std::size_t first);

}  // namespace mjforge::model
