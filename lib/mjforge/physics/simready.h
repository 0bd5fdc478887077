// Tests of the SimReady Foundation's benchmark.
#pragma once

#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/physics/joint_drive.h"
#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Runs the tests ground_drop 3.0.0, slope_drop, and full_range_sweep 1.4.0 of the benchmark's
/// families FET003 and FET022, and fills in result.simready. Skips the drops if the model has no
/// free bodies or no floor. `drives` has the results of DriveJoints(). `object` is the object's
/// name; findings point at `mark`. May throw std::exception.
void CheckSimReady(const mjModel& m, Workspace& workspace, const DriveResults& drives,
                   std::string_view object, diag::SourceMark mark,
                   static_checks::Reporter& reporter, Result& result);

}  // namespace mjforge::physics
