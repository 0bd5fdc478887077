#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// Compares the compiled sensors, actuators, tendons, equalities, pairs and excludes with the
/// object's: how many there are, their names, and the elements they refer to. Adds a finding for
/// each difference.
void CompareSections(const mjModel& m, const model::Object& object, diag::Findings& findings);

}  // namespace mjforge::validate
