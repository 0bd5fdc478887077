// Bounds of an object over the ranges of its joints.

#pragma once

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns a box, in the object's frame W, that contains `object.bounds` and the collision parts
/// (all parts if none collides) at all positions of the joints. Hinges without a range turn by 360
/// degrees. Slides without a range and free joints stay at the start. Equalities are ignored.
Box3 SweptBounds(const Object& object);

}  // namespace mjforge::model
