// Check that equality constraints hold while joints are driven.
#pragma once

#include "mjforge/physics/physics.h"
#include "mjforge/physics/simulation.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Drives the joints that equalities couple (DriveEqualities), writes result.equalities, and
/// reports errors above checks.equality_error at the place of the equality, or at `mark` if the
/// equality has no place. May throw std::exception.
void CheckEqualities(const mjModel& m, Workspace& workspace, const model::Object& object,
                     diag::SourceMark mark, static_checks::Reporter& reporter, Result& result);

}  // namespace mjforge::physics
