// Bounds of an object over the ranges of its joints.

#pragma once

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns the range of a hinge or slide as displacements from the joint's zero, rad or m. A hinge
/// without a range, or with one of a full turn or more, makes a full turn; a slide without a range
/// stays at its start.
Eigen::Vector2d DisplacementsOf(const Joint& joint);

/// Returns a box, in the object's frame W, that contains `object.bounds` and the collision parts
/// (all parts if none collides) at all positions of the joints. Hinges without a range turn by 360
/// degrees. Slides without a range and free joints stay at the start. Equalities are ignored.
Box3 SweptBounds(const Object& object);

}  // namespace mjforge::model
