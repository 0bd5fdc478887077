// Check of the joints in `view:`, the pose in which pictures show an object.

#pragma once

#include "mjforge/model/model.h"
#include "mjforge/spec/spec.h"

namespace mjforge::assemble {

/// Adds a warning for each joint in the pose of `view:` that the object does not have. There is no
/// warning if other variants may have the joint, because `if` or `for` leaves it out or its name is
/// drawn. The first words of a joint's name may be missing if exactly one joint matches.
void CheckShownPose(const spec::ObjectSpec& spec, const model::Object& object,
                    diag::Findings& findings);

}  // namespace mjforge::assemble
