// Outlines of holes through a prism along one axis, and their validation.

#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {

/// Holes along one axis, as given in the spec.
struct HoleGroup {
  std::span<const std::vector<Point2>> outlines;
  std::size_t first_loop = 1;   // Fault::loop of the first hole
  std::string_view along = {};  // "x" or "y", for messages; empty for holes along z
  /// Number of points of the outline and of the holes of earlier groups, because kMostPoints limits
  /// the total.
  std::size_t other_points = 0;
};

/// Returns the outlines of the holes, clockwise. Returns nullopt and sets `fault` if a hole is no
/// valid outline, is not inside of `around`, or meets another hole.
std::optional<std::vector<Outline>> HolesIn(const Outline& around, const HoleGroup& group,
                                            Fault& fault);

}  // namespace mjforge::solid
