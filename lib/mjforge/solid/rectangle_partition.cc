// Partition of an area into rectangles, if all sides of the area are parallel to the axes.

#include <algorithm>
#include <cmath>

#include "mjforge/solid/convex_partition.h"

namespace mjforge::solid {
namespace {

// Tolerance for equal coordinates, as a share of the area's size.
constexpr double kSame = 1e-12;

struct Side {
  Point2 from;
  Point2 to;
};

std::vector<Side> SidesOf(const Area& area) {
  std::vector<Side> sides;
  for (std::size_t loop = 0; loop < area.ends.size(); ++loop) {
    const auto [first, count] = area.Loop(loop);
    for (std::size_t i = 0; i < count; ++i)
      sides.push_back({area.corners[first + i], area.corners[first + (i + 1) % count]});
  }
  return sides;
}

/// Returns the x coordinates, in ascending order, at which vertical sides cross the row of
/// rectangles between the heights `low` and `high`.
std::vector<double> CrossingsOf(const std::vector<Side>& sides, double low, double high,
                                double same) {
  std::vector<double> crossings;
  for (const auto& [from, to] : sides) {
    const auto [least, most] = std::minmax(from.y(), to.y());
    if (least <= low + same && most >= high - same) crossings.push_back(from.x());
  }
  std::ranges::sort(crossings);
  return crossings;
}

}  // namespace

std::vector<std::vector<Point2>> ConvexPolygonsOf(const Area& area) {
  const double same = kSame * BoxAround(area.corners).diagonal().norm();
  const std::vector<Side> sides = SidesOf(area);
  const auto is_level_or_upright = [&](const Side& side) {
    return (side.to - side.from).cwiseAbs().minCoeff() <= same;
  };
  if (!std::ranges::all_of(sides, is_level_or_upright)) return MergedPolygonsOf(area);
  std::vector<std::vector<Point2>> polygons;
  std::vector<double> levels;
  for (const Point2& p : area.corners) levels.push_back(p.y());
  std::ranges::sort(levels);
  double low = levels.front();
  for (const double high : levels) {
    if (high - low <= same) continue;
    const std::vector<double> crossings = CrossingsOf(sides, low, high, same);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const double left = crossings[i];
      const double right = crossings[i + 1];
      polygons.push_back({{left, low}, {right, low}, {right, high}, {left, high}});
    }
    low = high;
  }
  return polygons;
}

}  // namespace mjforge::solid
