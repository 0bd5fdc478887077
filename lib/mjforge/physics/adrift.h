#pragma once

#include <vector>

#include <mujoco/mujoco.h>

namespace mjforge::physics {

/// A body on a hinge or slide, with nothing else of its object near it.
struct Adrift {
  int body = 0;
  double distance = 0;  // m, to the nearest other geom's bounding box
};

/// Bodies on hinges and slides farther from all else of their tree, where they start, than a
/// quarter of their own size. Boxes around geoms, seen ones too, tell.
/// `d` is the model's data at its initial state.
std::vector<Adrift> AdriftBodies(const mjModel& m, mjData& d);

}  // namespace mjforge::physics
