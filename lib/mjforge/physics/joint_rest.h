// Predicates and hints for joints at rest: allowed positions (`rests`), and creep in spite of dry
// friction.
#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"

namespace mjforge::physics {

/// Returns true if an entry of checks.joints has `rests`.
bool HasRestRanges(const model::Checks& checks);

/// Returns a remedy if a joint creeps although its dry friction is larger than its load; an empty
/// text if the joint does not creep. `d` has the forces of the last step.
std::string CreepRemedy(const mjModel& m, const mjData& d, int joint);

}  // namespace mjforge::physics
