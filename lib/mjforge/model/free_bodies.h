#pragma once

#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Makes each body with a free joint one of the world, which stays where its parent has it. A
/// finding for one whose parent moves by another joint, and for one that has further joints.
void ReleaseFreeBodies(std::vector<Body>& bodies, diag::Findings& findings);

}  // namespace mjforge::model
