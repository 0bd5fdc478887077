// Masses and bounds of bodies and subtrees, computed from their parts.

#pragma once

#include <vector>

#include "mjforge/model/assets.h"
#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns the extents of the parts from `first` on: of the parts that collide, if any does.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);
/// Returns bounds and mass of the bodies from `first` on, at the start state, in the frame F of
/// SubtreePoses().
Bounds SubtreeBounds(const std::vector<Body>& bodies, std::size_t first);
MassProperties SubtreeMass(const std::vector<Body>& bodies, std::size_t first);
/// Returns the bounds of a box with these half sizes, m, for `total_size:`.
Bounds DeclaredBounds(const Eigen::Vector3d& total_size);

/// Sets a body's mass properties to the sum of its parts, unless an attached file gave them.
void SumMass(Body& body, Assets& assets);
/// Multiplies the mass of the parts from `first_part` on of one body, and of the bodies from
/// `first_body` on, by `factor`.
void ScaleMass(double factor, std::vector<Body>& bodies, std::size_t body, std::size_t first_part,
               std::size_t first_body);
/// Gives each massless body with joints half the mass of the first body that is fixed to it.
void ShareMass(std::vector<Body>& bodies);

}  // namespace mjforge::model
