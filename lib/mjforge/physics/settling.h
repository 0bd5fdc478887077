// Settling test: free bodies stay where they start, on a table, in a box, on each other.
#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Simulates the model from its start for checks.settled->time, and adds a finding for each free
/// body that moves or turns by more than the limits of checks.settled. If the root of the object is
/// free, the object is put on the floor, and motions are relative to the root. Fills in
/// result.settled. May enlarge the model's buffers for contacts. May throw std::exception.
void CheckSettled(mjModel& m, Workspace& workspace, const std::string& object,
                  static_checks::Reporter& reporter, Result& result);

}  // namespace mjforge::physics
