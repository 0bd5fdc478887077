// Positions of the joints in the picture on the page of `mjforge customize`.
#pragma once

#include "mjforge/customize/request.h"
#include "mjforge/customize/variant_cache.h"

namespace mjforge::customize {

/// Sets the pose of the picture. Moves all joints to the base pose of the request (view, start or
/// zero), and stores the joints in this pose in shown.joints. Then moves the joints that the
/// request names to their positions, clamped to their ranges. `shown.subject` must not be null.
void MoveJoints(const Request& request, ShownVariant& shown);

}  // namespace mjforge::customize
