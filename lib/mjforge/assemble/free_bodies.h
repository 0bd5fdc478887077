// Bodies with free joints, which MuJoCo requires to be children of the world.

#pragma once

#include <vector>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Makes each body with a free joint a child of the world, at its present pose. Adds a finding if
/// the body has further joints, or is on a body that moves by another joint.
void ReleaseFreeBodies(std::vector<model::Body>& bodies, diag::Findings& findings);

}  // namespace mjforge::assemble
