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

/// An MJCF text with the pegs of checks.fits.
std::string WithPegs(std::string_view text, const model::Checks& checks);

/// Drops each peg, and each body that has to fit, along the z axis of its hole's site, all else
/// being held, and says which of them do not get as deep as they should, or could leave sideways
/// there. Fills in result.fits. `m`
/// is a model of such a text, and is changed; `start` (nq of the object alone) has the positions of
/// its joints. May throw std::exception.
void CheckFitting(mjModel& m, Workspace& workspace, std::span<const mjtNum> start,
                  const std::string& name, Verdict& verdict, Result& result);

}  // namespace mjforge::physics
