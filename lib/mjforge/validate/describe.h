#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/validate/validate.h"

namespace mjforge::validate {

CompiledModel Describe(const mjModel& m);

/// Adds a finding for each kind of number that is not finite: MuJoCo silently loads "nan".
void CheckFinite(const mjModel& m, diag::SourceMark mark, diag::Findings& findings);

}  // namespace mjforge::validate
