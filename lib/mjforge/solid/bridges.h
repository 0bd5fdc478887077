#pragma once

#include <utility>
#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// One loop through all corners of an area, as indices of them, counter-clockwise: the outline, and
/// from it over a bridge into each hole, around it and back. `cuts` gets the bridges. Source:
/// Eberly, "Triangulation by ear clipping", section 3.
std::vector<int> RingOf(const Area& area, std::vector<std::pair<int, int>>& cuts);

}  // namespace mjforge::solid
