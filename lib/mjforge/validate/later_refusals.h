// Models that MuJoCo 2.2 accepts and later releases reject.
#pragma once

#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// Adds an error, at its place in the spec, for each mesh, camera, tendon and attribute of the
/// object that later releases reject. `m` is the compiled object.
void FindLaterRefusals(const mjModel& m, const model::Object& object, diag::Findings& findings);

/// Adds a warning for each mesh, camera and tendon of a file that later releases reject.
/// backport::ReadModelFile() reports the file's attributes.
void FindLaterRefusals(const mjModel& m, diag::SourceMark mark, diag::Findings& findings);

}  // namespace mjforge::validate
