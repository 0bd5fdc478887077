// Bodies with free joints, which must be children of the world in MJCF.

#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Makes each body with a free joint a child of the world, without changing its pose in the world.
/// Adds a finding if the body has further joints, or if a joint moves one of its ancestors.
void ReleaseFreeBodies(std::vector<model::Body>& bodies, diag::Findings& findings);

}  // namespace mjforge::assemble
