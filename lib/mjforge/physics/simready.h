#pragma once

#include <string>

#include <mujoco/mujoco.h>

#include "mjforge/physics/drive.h"
#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// What the findings are about.
struct Subject {
  std::string name;
  diag::SourceMark mark;
};

/// Tests a model, which has a floor if it is free, as the SimReady Foundation's benchmark does
/// (tests ground_drop 3.0.0, slope_drop, full_range_sweep 1.4.0 of its FET003 and FET022 families);
/// `drives` has the joints as they were driven. Fills in result.simready. May throw
/// std::exception.
void CheckSimReady(const mjModel& m, Workspace& workspace, const Drives& drives,
                   const Subject& subject, Verdict& verdict, Result& result);

}  // namespace mjforge::physics
