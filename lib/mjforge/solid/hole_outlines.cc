// Validation of the holes of a prism: each hole is inside the shape, and no two holes meet.

#include "mjforge/solid/hole_outlines.h"

#include <string>

#include <fmt/format.h>

namespace mjforge::solid {
namespace {

/// Returns the fault of the last hole (Fault::loop is not set); nullopt if the hole is inside of
/// `around` and meets no other hole.
std::optional<Fault> FaultOfLast(const std::vector<Outline>& holes, const Outline& around,
                                 std::string_view along) {
  const Outline& hole = holes.back();
  if (const auto at = FirstContact(hole, around))
    return Fault{"begins a line that crosses or touches the edge of the shape", hole.sources[*at]};
  if (!Contains(around, hole.corners[0])) return Fault{"is outside of the shape"};
  for (std::size_t k = 0; k + 1 < holes.size(); ++k) {
    const std::string other =
        fmt::format("hole {}{}{}", k + 1, along.empty() ? "" : " along ", along);
    if (const auto at = FirstContact(hole, holes[k]))
      return Fault{fmt::format("begins a line that crosses or touches {}", other),
                   hole.sources[*at]};
    if (Contains(holes[k], hole.corners[0]) || Contains(hole, holes[k].corners[0]))
      return Fault{fmt::format("and {} lie in each other", other)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<Outline>> HolesIn(const Outline& around, const HoleGroup& group,
                                            Fault& fault) {
  std::vector<Outline> holes;
  std::size_t count = group.other_points;
  for (const std::vector<Point2>& points : group.outlines) {
    const std::size_t loop = group.first_loop + holes.size();
    std::optional<Outline> hole = OutlineOf(points, fault);
    count += points.size();
    if (hole && count > kMostPoints) {
      fault = {fmt::format("is one of holes with more than {} points", kMostPoints)};
      hole.reset();
    }
    if (hole) {
      hole->Reverse();
      holes.push_back(*std::move(hole));
      if (const std::optional<Fault> found = FaultOfLast(holes, around, group.along))
        fault = *found;
    }
    if (fault.message.empty()) continue;
    fault.loop = loop;
    return std::nullopt;
  }
  return holes;
}

}  // namespace mjforge::solid
