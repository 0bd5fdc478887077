// Prisms for tests of solids: random outlines, containment, faults as text.

#pragma once

#include <cstdlib>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "reference_geometry.h"

namespace mjforge::solid {

using Points = std::vector<Vector2d>;

/// Returns a star-shaped polygon about a middle point.
inline Points RandomStar(Random& random, const Vector2d& middle, double least, double most,
                         int corners) {
  Points points;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * kPi * (i + random.Uniform(0.25, 0.75)) / corners;
    points.push_back(middle +
                     random.Uniform(least, most) * Vector2d(std::cos(turn), std::sin(turn)));
  }
  if (random.Integer(2) == 0) std::ranges::reverse(points);
  return points;
}

/// Returns true if a prism without roundings and bevels contains the point.
inline bool IsInside(const Prism& prism, const Vector3d& p) {
  const auto in = [](const std::vector<Points>& outlines, double u, double v) {
    return std::ranges::any_of(outlines,
                               [&](const Points& outline) { return Contains(outline, u, v); });
  };
  return std::abs(p.z()) <= prism.height / 2 && Contains(prism.polygon, p.x(), p.y()) &&
         !in(prism.holes, p.x(), p.y()) && !in(prism.holes_x, p.y(), p.z()) &&
         !in(prism.holes_y, p.x(), p.z());
}

/// Returns the fault with its place, "ok" if there is none.
inline std::string PrismFault(const Prism& prism) {
  Fault fault;
  if (Make(prism, fault)) return "ok";
  const std::string hole = fault.loop > 0 ? fmt::format("hole {} ", fault.loop) : "";
  return hole + (fault.point ? fmt::format("{}: ", *fault.point) : "") + fault.message;
}

}  // namespace mjforge::solid
