// Connected components of parts that touch, by union-find.
#include "mjforge/static_checks/connected_parts.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace mjforge::static_checks {

std::vector<PartGroup> ConnectedGroups(std::span<const PlacedPart> parts, double gap) {
  PartGroup leader(parts.size());
  std::iota(leader.begin(), leader.end(), 0);
  const auto find = [&](std::size_t i) {
    while (leader[i] != i) i = leader[i] = leader[leader[i]];
    return i;
  };
  for (std::size_t i = 1; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool are_near = parts[i].box_W.exteriorDistance(parts[j].box_W) <= gap;
      if (are_near && find(i) != find(j) && Distance(parts[i], parts[j]) <= gap)
        leader[find(i)] = find(j);
    }
  }
  std::vector<PartGroup> groups(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) groups[find(i)].push_back(i);
  std::erase_if(groups, [](const PartGroup& group) { return group.empty(); });
  const auto mass = [&](const PartGroup& group) {
    double sum = 0;
    for (const std::size_t i : group) sum += parts[i].part->mass;
    return sum;
  };
  std::ranges::stable_sort(groups, std::ranges::greater(), mass);
  return groups;
}

NearestPart NearestOutside(std::span<const PlacedPart> parts, const PartGroup& group) {
  NearestPart nearest = {.distance = std::numeric_limits<double>::infinity()};
  for (std::size_t other = 0; other < parts.size(); ++other) {
    if (std::ranges::find(group, other) != group.end()) continue;
    for (const std::size_t own : group) {
      if (parts[own].box_W.exteriorDistance(parts[other].box_W) >= nearest.distance) continue;
      const double distance = Distance(parts[own], parts[other]);
      if (distance < nearest.distance) nearest = {other, distance};
    }
  }
  return nearest;
}

}  // namespace mjforge::static_checks
