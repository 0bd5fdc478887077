// The pose in which pictures show an object.

#pragma once

#include "mjforge/model/model.h"
#include "mjforge/spec/spec.h"

namespace mjforge::assemble {

/// Adds a warning for each joint in the pose of the spec's `view:` that the object does not have,
/// unless it may have the joint in other variants: `if` or `for` leaves it out, or its name depends
/// on what is drawn. The first words of a joint's name may be missing if only one joint fits.
void CheckShownPose(const spec::ObjectSpec& spec, const model::Object& object,
                    diag::Findings& findings);

}  // namespace mjforge::assemble
