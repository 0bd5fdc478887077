// Finds elements and attributes that this MuJoCo accepts and later releases reject.
#pragma once

#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// Adds an error for each mesh, camera, tendon and attribute of the object that later releases
/// reject, at its place in the spec. `m` is the model compiled from the object.
void FindLaterRefusals(const mjModel& m, const model::Object& object, diag::Findings& findings);

/// Adds a warning, at `mark`, for each mesh, camera and tendon of a file that later releases
/// reject. `m` is the model compiled from the file. Attributes of the file are left out, because
/// backport::ReadModelFile() reports them.
void FindLaterRefusals(const mjModel& m, diag::SourceMark mark, diag::Findings& findings);

}  // namespace mjforge::validate
