// Check that an object has the joints in `view:`, the pose in which pictures show the object.

#pragma once

#include "mjforge/model/model.h"
#include "mjforge/spec/spec.h"

namespace mjforge::assemble {

/// Adds a warning for each joint in the pose of `view:` that the object does not have. There is no
/// warning if other variants may have the joint: in this variant, `if` or `for` leaves the joint
/// out, or its name is drawn. The first words of a joint's name may be missing; adds a warning if
/// several joints match, or if the position is not in the unit of its joint.
void CheckShownPose(const spec::ObjectSpec& spec, const model::Object& object,
                    diag::Findings& findings);

}  // namespace mjforge::assemble
