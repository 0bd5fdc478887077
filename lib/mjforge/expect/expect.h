#pragma once

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::expect {

/// Adds an error for each of object.expectations that does not hold, with the numbers found and
/// asked, and for each condition of object.unmet. Shapes are exact, meshes count as their convex
/// hulls; a part that only shows counts where nothing of its body collides.
void CheckExpectations(const model::Object& object, diag::Findings& findings);

/// Lengths in m that are less than this are rounding.
inline constexpr double kTolerance = 1e-5;

}  // namespace mjforge::expect
