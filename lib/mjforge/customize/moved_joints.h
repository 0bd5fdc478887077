// Positions of the joints in the picture of the page.
#pragma once

#include "mjforge/customize/request.h"
#include "mjforge/customize/variant_cache.h"

namespace mjforge::customize {

/// Moves all joints to the base pose of the request (view, start or zero), and then the joints that
/// the request names to their positions, clamped to their ranges. Sets shown.joints to the joints
/// in the base pose. `shown` must have a subject.
void MoveJoints(const Request& request, ShownVariant& shown);

}  // namespace mjforge::customize
