// Masses and bounds of bodies and subtrees, computed from their parts.

#pragma once

#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns the bounds of a part at the pose X_AG: those of its exact solid, if it has one.
Box3 BoundsOf(const Part& part, const Pose& X_AG);
/// Returns the extents of the parts from `first` on: of the parts that collide, if any does.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);
/// Returns bounds and mass of the body `first` and all below it, at the start state, in the frame F
/// of SubtreePoses().
Bounds SubtreeBounds(const std::vector<Body>& bodies, std::size_t first);
MassProperties SubtreeMass(const std::vector<Body>& bodies, std::size_t first);
/// Returns the bounds of a box with these half sizes, m, for `total_size:`.
Bounds DeclaredBounds(const Eigen::Vector3d& total_size);

/// Computes mass properties and bounds of the object again, after bodies or their start were moved.
void MeasureAtStart(Object& object);

/// Multiplies the mass of the parts from `first_part` on of one body, and of the bodies from
/// `first_body` on, by `factor`.
void ScaleMass(double factor, std::vector<Body>& bodies, std::size_t body, std::size_t first_part,
               std::size_t first_body);
/// Gives each massless body with joints half the mass of the first body that is fixed to it.
void ShareMass(std::vector<Body>& bodies);

}  // namespace mjforge::model
