// Masses and bounds of bodies and subtrees, computed from their parts.

#pragma once

#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns the bounds of a part at the pose X_AG: of its exact solid if Part::extent is set,
/// otherwise of its shape.
Box3 BoundsOf(const Part& part, const Pose& X_AG);
/// Returns the bounds of the parts with an index from `first` on; of the colliding parts only, if
/// any part collides.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);
/// Returns bounds and mass of the body `first` and its descendants, at the start state, in the
/// frame F of SubtreePoses().
Bounds SubtreeBounds(const std::vector<Body>& bodies, std::size_t first);
MassProperties SubtreeMass(const std::vector<Body>& bodies, std::size_t first);
/// Returns the bounds of a box with these half sizes, m, for `total_size:`.
Bounds DeclaredBounds(const Eigen::Vector3d& total_size);

/// Updates mass properties and bounds of the object after a change of its bodies or their start.
void MeasureAtStart(Object& object);

/// Multiplies by `factor` the masses of the parts of body `body` with an index from `first_part`
/// on, and the masses of all bodies with an index from `first_body` on.
void ScaleMass(double factor, std::vector<Body>& bodies, std::size_t body, std::size_t first_part,
               std::size_t first_body);
/// Gives each massless body with joints half the mass of the first body that is fixed to it.
void ShareMass(std::vector<Body>& bodies);

}  // namespace mjforge::model
