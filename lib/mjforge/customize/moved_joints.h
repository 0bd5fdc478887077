// Positions of the joints in the picture of the page.
#pragma once

#include "mjforge/customize/request.h"
#include "mjforge/customize/variant_cache.h"

namespace mjforge::customize {

/// Moves the joints of the request, each within its range, and all others to the base pose. The
/// variant must have a subject.
void MoveJoints(const Request& request, ShownVariant& shown);

}  // namespace mjforge::customize
