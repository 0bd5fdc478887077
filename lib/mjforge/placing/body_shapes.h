// Shapes, poses and masses of a body and of all bodies below it, at the start state.

#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::placing {

/// A shape of a given body A or of a body below A.
struct BodyShape {
  int body = -1;
  model::Shape shape;
  model::Pose X_AG;
};

/// Returns the colliding shapes of a body A and of all bodies below A; all shapes if none collides.
std::vector<BodyShape> ShapesBelow(const model::Object& object, int body);

/// Returns the mass properties of a body A with all bodies below A, in the frame of A.
model::MassProperties MassBelow(const model::Object& object, int body);

/// Returns the pose of a body in the frame W of the object.
model::Pose PoseInWorld(const model::Object& object, int body);

}  // namespace mjforge::placing
