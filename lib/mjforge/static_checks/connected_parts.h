// Groups of parts of a body that are connected because they touch.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mjforge/static_checks/placed_part.h"

namespace mjforge::static_checks {

/// Indices into a list of parts.
using PartGroup = std::vector<std::size_t>;

/// Returns the connected components of the parts, the heaviest component first. Two parts are
/// connected if their distance is at most `gap`, m.
std::vector<PartGroup> ConnectedGroups(std::span<const PlacedPart> parts, double gap);

/// Index of the part that is nearest to a group and not in the group, and its distance. The
/// distance is infinite if all parts are in the group.
struct NearestPart {
  std::size_t index = 0;
  double distance = 0;  // m
};
NearestPart NearestOutside(std::span<const PlacedPart> parts, const PartGroup& group);

}  // namespace mjforge::static_checks
