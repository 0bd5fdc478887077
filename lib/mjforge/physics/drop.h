// Drop test: an object falls 2 mm onto a floor, or is nudged on the floor, and comes to rest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/film_recorder.h"
#include "mjforge/physics/physics.h"

namespace mjforge::physics {

/// Facts about a drop for messages, beside the measurements that SimulateDrop() stores in the
/// `Result` (physics.h).
struct DropOutcome {
  bool has_diverged = false;
  std::vector<std::string> warnings;  // MuJoCo's warnings during the drop
  std::string fastest;                // name of the body that is fastest at the end
  double displacement = 0;            // m, of the centre of mass of `fastest` since the start
};

/// Initial disturbance of all free bodies: a tilt, and a speed along the floor.
struct Nudge {
  double tilt = 0;     // rad
  double speed = 0;    // m/s
  double azimuth = 0;  // rad, direction of tilt and speed, from x towards y
};

/// Simulates a drop with the model's own options until everything rests or checks.settle_time is
/// over. Without a nudge, the drop always lasts for checks.settle_time if an entry of checks.joints
/// has `rests`. With a nudge, the object counts as at rest only if it leans by at most half of
/// checks.nudge. If the only fixed colliding geom is a level plane, the free bodies start
/// DropHeight() above the plane, or LargestMargin() above the plane with a nudge. `d` is the
/// model's data at its initial state, and holds the final state afterwards; the model is unchanged.
/// Fills in the members of `result` that a drop measures, and records the drop unless `recorder` is
/// null. `result.tilt` is relative to the orientation before the nudge. May throw std::exception.
DropOutcome SimulateDrop(mjModel& m, mjData& d, const model::Checks& checks, const Nudge& nudge,
                         Result& result, FilmRecorder* recorder = nullptr);

/// Returns the id of the only free body, which can be nudged because the only fixed geom that
/// collides is a level floor; nullopt if there is no such floor, or not exactly one free body.
/// Computes the poses in `d` (mj_kinematics).
std::optional<int> FreeStandingBody(const mjModel& m, mjData& d);

}  // namespace mjforge::physics
