// Masses and bounds of bodies and subtrees, computed from their parts.

#pragma once

#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns the bounding box of a part with the pose X_AG: of its exact solid if Part::extent is
/// set, otherwise of its shape.
Box3 BoundsOf(const Part& part, const Pose& X_AG);
/// Returns the bounds of the parts whose index is at least `first`. If any of these parts collides,
/// only colliding parts are included.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);
/// Return the bounds and the mass of the body `first` and its descendants at the start state, in
/// the frame F of SubtreePoses().
Bounds SubtreeBounds(const std::vector<Body>& bodies, std::size_t first);
MassProperties SubtreeMass(const std::vector<Body>& bodies, std::size_t first);
/// Returns the bounds for `total_size:`, a box with these half sizes, m.
Bounds DeclaredBounds(const Eigen::Vector3d& total_size);

/// Updates the mass properties and bounds of the object. Call MeasureAtStart() after a change of
/// the object's bodies or their start.
void MeasureAtStart(Object& object);

/// Multiplies by `factor` the masses of the parts of body `body` from index `first_part` on, and
/// the masses of all bodies from index `first_body` on.
void ScaleMass(double factor, std::vector<Body>& bodies, std::size_t body, std::size_t first_part,
               std::size_t first_body);
/// Gives each body with joints but without mass half the mass of the first descendant that is fixed
/// to the body and has mass.
void ShareMass(std::vector<Body>& bodies);

}  // namespace mjforge::model
