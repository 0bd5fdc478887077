// Shapes, poses and masses of a body and of all bodies below it, at the start state.

#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::placing {

/// A shape of the body with the index `body`, or of a body below a body A.
struct BodyShape {
  int body = -1;
  model::Shape shape;
  model::Pose X_AG;
};

/// Returns the colliding shapes of a body A and of all bodies below it; if none collides, all.
std::vector<BodyShape> ShapesBelow(const model::Object& object, int body);

/// Returns the mass properties of a body A and all bodies below it, in A.
model::MassProperties MassBelow(const model::Object& object, int body);

/// Returns the pose of a body in the frame W of the object.
model::Pose PoseInWorld(const model::Object& object, int body);

}  // namespace mjforge::placing
