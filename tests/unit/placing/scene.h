// Fixture: objects made of bodies with given shapes.

#pragma once

#include <string>
#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::placing {

model::Pose At(double x, double y, double z, double yaw = 0);

model::Shape ShapeOf(model::GeomType type, double x, double y = 0, double z = 0);

/// An object whose bodies are added one after the other.
class Scene {
 public:
  /// Adds a body with one colliding part in its origin, of density 1000 kg/m^3.
  int Add(const model::Shape& shape, const model::Pose& X_PB = {}, int parent = -1);
  /// Adds a part to the last body.
  void AddPart(const model::Shape& shape, const model::Pose& X_BG,
               model::Role role = model::Role::kCollision);
  /// Adds an open bin with a square floor at the height 0, and returns its body.
  int AddBin(double half_inside, double height, double thickness);

  model::Body& body(int index) { return object.bodies[static_cast<std::size_t>(index)]; }

  model::Object object;
};

model::Region BoxRegion(double half_x, double half_y, double z = 0);

}  // namespace mjforge::placing
