// Hole bridging: turns a polygon with holes into a single loop for ear clipping.

#pragma once

#include <utility>
#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// Returns a single counter-clockwise loop through all corners of an area, as indices of corners:
/// the outline with a detour over a bridge into each hole, around the hole and back. Adds the
/// bridges to `cuts`. Source: Eberly, "Triangulation by ear clipping", section 3.
std::vector<int> BridgeHoles(const Area& area, std::vector<std::pair<int, int>>& cuts);

}  // namespace mjforge::solid
