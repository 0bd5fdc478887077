// Warns of differences between the models that this MuJoCo and later releases compile from the same
// file.
#pragma once

#include "mjforge/backport/backport.h"
#include "mjforge/diag/diag.h"
#include "mjforge/engine/engine.h"

namespace mjforge::validate {

/// Compares two models of one file: `as_is`, which this MuJoCo has compiled from the unchanged
/// file, and `m`, which this MuJoCo has compiled under the rules of later releases. Adds a warning
/// if this MuJoCo rejects the unchanged file, or if masses of bodies, or sizes or positions of
/// geoms, differ. `places` contains the first elements to which the rules apply differently.
void CompareReleases(const mjModel& m, const engine::Loaded& as_is,
                     const backport::RuleDifferences& places, diag::Findings& findings);

}  // namespace mjforge::validate
