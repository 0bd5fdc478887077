// The pose in which pictures show an object.

#pragma once

#include "mjforge/model/model.h"
#include "mjforge/spec/spec.h"

namespace mjforge::assemble {

/// Adds a warning for each joint in the pose of the spec's `view:` that the object does not have,
/// unless the spec lists the joint and `if` leaves it out. The first words of a joint's name may be
/// missing if only one joint fits.
void CheckShownPose(const spec::ObjectSpec& spec, const model::Object& object,
                    diag::Findings& findings);

}  // namespace mjforge::assemble
