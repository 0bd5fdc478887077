// Joint positions for the picture on the page of `mjforge customize`.
#pragma once

#include "mjforge/customize/page_request.h"
#include "mjforge/customize/variant_cache.h"

namespace mjforge::customize {

/// Sets the pose of `shown.subject` for a picture. Moves all joints to the base pose of the request
/// (view, start or zero), and sets shown.joints to the joints in this pose. Then moves the hinges
/// and slides that the request names to the requested positions, clamped to their ranges.
/// `shown.subject` must not be null.
void MoveJoints(const Request& request, ShownVariant& shown);

}  // namespace mjforge::customize
