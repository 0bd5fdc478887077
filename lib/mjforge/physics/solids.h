#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::physics {

/// What a body is made of: the parts that collide, or all of them if none does. Where only the
/// mass of the whole is known, each has its share by volume.
struct Solids {
  std::vector<model::Part> parts;
  bool masses_known = false;
  /// kg, of the parts. The body may have given half of it to the body it is fixed to.
  double mass = 0;
};

Solids SolidsOf(const model::Body& body);

/// The box around each part, in the body's frame.
std::vector<model::Box3> BoxesOf(const std::vector<model::Part>& parts);

}  // namespace mjforge::physics
