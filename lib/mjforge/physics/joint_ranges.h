// Check for joint ranges that are too large for real joints.
#pragma once

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Returns the longest range that a slide of the object should have, m; infinite if the object has
/// no size.
double LongestSlide(const model::Object& object, const model::Checks& checks);

/// Warns of hinges with a range above checks.hinge_range, and of slides with a range above
/// checks.slide_range times the object's longest side, unless they are coupled to other joints.
/// Findings about joints without a place point at `mark`.
void CheckRanges(const mjModel& m, const model::Object& object, diag::SourceMark mark,
                 static_checks::Reporter& reporter);

}  // namespace mjforge::physics
