// Bodies with free joints, which must be children of the world in MJCF.

#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Makes each body with a free joint a child of the world, without changing its pose in the world.
/// Adds a finding instead if the body has further joints, or if an ancestor has joints but no free
/// joint and the body has no `place:`.
void ReleaseFreeBodies(std::vector<model::Body>& bodies, diag::Findings& findings);

}  // namespace mjforge::assemble
