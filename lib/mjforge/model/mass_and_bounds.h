// Masses and bounds of bodies and subtrees, computed from their parts.

#pragma once

#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns the bounding box, in frame A, of a part with the pose X_AG: the box of the exact solid
/// if Part::extent is set, otherwise the box of Part::shape.
Box3 BoundsOf(const Part& part, const Pose& X_AG);
/// Returns the bounds, in the frame of the body, of the parts whose index is at least `first`. If
/// any of these parts collides, only colliding parts are included.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);
/// Return the bounds and the mass of the body `first` and its descendants at the start state, in
/// the frame F of SubtreePoses(). The bounds exclude parts of the body before index `first_part`
/// and descendants before index `first_body`.
Bounds SubtreeBounds(const std::vector<Body>& bodies, std::size_t first, std::size_t first_part = 0,
                     std::size_t first_body = 0);
MassProperties SubtreeMass(const std::vector<Body>& bodies, std::size_t first);
/// Returns the bounds for `total_size:`, a box with these half sizes, m.
Bounds DeclaredBounds(const Eigen::Vector3d& total_size);

/// Computes the mass properties and the bounds of the object at its start state; keeps declared
/// bounds. Must be called after a change of the object's bodies or their start.
void MeasureAtStart(Object& object);

/// Multiplies masses by `factor`: of the parts of the body with index `body` from index
/// `first_part` on, and of all bodies from index `first_body` on, with their parts. Does not change
/// the mass properties of the body `body`. Sets Part::density of the changed parts to 0.
void ScaleMass(double factor, std::vector<Body>& bodies, std::size_t body, std::size_t first_part,
               std::size_t first_body);
/// Gives each body that has joints but no mass half the mass and inertia of its first descendant
/// that has mass and is fixed to the body (no joints in between).
void ShareMass(std::vector<Body>& bodies);

}  // namespace mjforge::model
