#pragma once

#include <span>
#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// An MJCF text with the balls of checks.holds.
std::string WithBalls(std::string_view text, const model::Holding& holding);

/// Drops the balls into the object, which is held, and then turns it over. Says which of them it
/// loses or keeps, and fills in result.holds. `m` is a model of such a text, and is changed;
/// `start` ends with the positions of the object's joints, as many as `m` has of them. May throw
/// std::exception.
void CheckHolding(mjModel& m, Workspace& workspace, std::span<const mjtNum> start,
                  const std::string& name, Verdict& verdict, Result& result);

}  // namespace mjforge::physics
