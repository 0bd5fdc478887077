#ifndef MJFORGE_PHYSICS_SETTLE_H_
#define MJFORGE_PHYSICS_SETTLE_H_

#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// What a drop ended in beside numbers.
struct Trouble {
  bool blown_up = false;  // numbers that are none, or too large
  std::vector<std::string> warnings;
  std::string fastest;  // the body that is fastest at the end
  double way = 0;       // of its centre of mass from the start, m
};

/// Puts what is free above the floor by DropHeight(), if the model has a level
/// plane and one free body and nothing else to lie on, and simulates from there with
/// the model's own options: until it rests, or checks.settle_time is over. `d` is
/// the model's data at its initial state; it is left as the drop left it, the model
/// as it was. Fills in all of `result` but overlap and joints. May throw
/// std::exception.
Trouble Settle(mjModel& m, mjData& d, const model::Checks& checks, Result& result);

}  // namespace mjforge::physics

#endif  // MJFORGE_PHYSICS_SETTLE_H_
