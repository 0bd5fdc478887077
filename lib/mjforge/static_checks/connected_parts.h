// Groups of parts that are connected because they touch.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mjforge/static_checks/placed_part.h"

namespace mjforge::static_checks {

/// Indices into a list of parts.
using PartGroup = std::vector<std::size_t>;

/// Returns the connected components of the parts, the heaviest component first. Parts are connected
/// if their distance is at most `gap`, m.
std::vector<PartGroup> ConnectedGroups(std::span<const PlacedPart> parts, double gap);

/// Part outside a group that is nearest to the group. The distance is infinite if there is no such
/// part.
struct NearestPart {
  std::size_t index = 0;
  double distance = 0;  // m
};
NearestPart NearestOutside(std::span<const PlacedPart> parts, const PartGroup& group);

}  // namespace mjforge::static_checks
