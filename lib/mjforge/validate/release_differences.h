// Differences between the models that MuJoCo 2.2 and later releases compile from the same file.
#pragma once

#include "mjforge/backport/backport.h"
#include "mjforge/diag/diag.h"
#include "mjforge/engine/engine.h"

namespace mjforge::validate {

/// Adds a warning if the MuJoCo of this build rejects the file, or gives its bodies other masses or
/// its geoms other shapes than later releases. `as_is` is the unchanged file, loaded by this
/// MuJoCo; `m` is the model of later releases; `places` are the elements that can differ.
void CompareReleases(const mjModel& m, const engine::Loaded& as_is,
                     const backport::RuleDifferences& places, diag::Findings& findings);

}  // namespace mjforge::validate
