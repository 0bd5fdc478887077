#pragma once

#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// What went wrong in a drop.
struct Trouble {
  bool blown_up = false;  // numbers became NaN or too large
  std::vector<std::string> warnings;
  std::string fastest;  // the body that is fastest at the end
  double way = 0;       // of its centre of mass from the start, m
};

/// What happens to a free body as it is let go: it leans, and moves along the floor.
struct Nudge {
  double tilt = 0;     // rad
  double speed = 0;    // m/s
  double azimuth = 0;  // rad, from x towards y: which way
};

/// If the model has a level plane, one free body and nothing else to lie on, puts that body
/// DropHeight() above the floor. Simulates from there with the model's own options until it rests
/// or checks.settle_time is over; for all of that time if an entry of checks.joints says `rests`.
/// `d` is the model's data at its initial state; afterwards it holds the end of the drop, and the
/// model is unchanged. Fills in all of `result` that a drop tells; the tilt is that from before the
/// nudge. May throw std::exception.
Trouble Settle(mjModel& m, mjData& d, const model::Checks& checks, const Nudge& nudge,
               Result& result);

/// The body that stands alone on a level floor, so that it can be nudged; -1: there is none.
int NudgedBody(const mjModel& m, mjData& d);

}  // namespace mjforge::physics
