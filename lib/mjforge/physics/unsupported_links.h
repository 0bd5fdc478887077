// Bodies on hinges and slides with nothing else of their object near them.
#pragma once

#include <vector>

#include <mujoco/mujoco.h>

namespace mjforge::physics {

struct UnsupportedLink {
  int body = 0;
  double distance = 0;  // m, between bounding boxes of geoms
};

/// Returns the bodies on hinges and slides whose distance from other bodies of their tree, at the
/// start positions, is more than a quarter of their own size. Compares bounding boxes of all geoms,
/// including visual ones. `d` is the model's data at its initial state.
std::vector<UnsupportedLink> FindUnsupportedLinks(const mjModel& m, mjData& d);

}  // namespace mjforge::physics
