// Arcs that replace the corners of an outline, and points along them.

#include "mjforge/solid/rounded_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace mjforge::solid {
namespace {

constexpr double kNoTurn = 1e-9;     // turns up to this are straight, rad
constexpr double kTolerance = 1e-9;  // tolerance as a share of a side's length

double TurnAt(const Outline& outline, std::size_t i) {
  const Point2 in = outline.corners[i] - outline.corners[outline.Previous(i)];
  const Point2 out = outline.corners[outline.Next(i)] - outline.corners[i];
  const double turn = std::atan2(Cross(in, out), in.dot(out));
  return std::abs(turn) > kNoTurn ? turn : 0;
}

}  // namespace

std::optional<std::vector<RoundedCorner>> RoundCorners(const Outline& outline,
                                                       const std::vector<double>& radii,
                                                       double inset, Fault& fault) {
  const std::size_t count = outline.corners.size();
  std::vector<double> turns;
  for (std::size_t i = 0; i < count; ++i) turns.push_back(TurnAt(outline, i));
  const auto taken = [&](std::size_t i) { return radii[i] * std::tan(std::abs(turns[i]) / 2); };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = outline.Next(i);
    const double length = (outline.corners[next] - outline.corners[i]).norm();
    if (taken(i) + taken(next) <= length * (1 + kTolerance)) continue;
    return Fail(fault,
                fmt::format("leaves a side of {:g} m, too short for corners of {:g} m", length,
                            std::max(radii[i], radii[next])),
                outline.sources[i]);
  }
  const std::vector<Point2> moved = ParallelOf(outline, inset);
  std::vector<RoundedCorner> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = turns[i];
    const double own = turn > 0 ? radii[i] - inset : radii[i] + inset;
    if (radii[i] == 0 || turn == 0) {
      corners.push_back({.place = moved[i]});
      continue;
    }
    const Point2 in = (outline.corners[i] - outline.corners[outline.Previous(i)]).normalized();
    const double side = turn > 0 ? 1 : -1;
    const Point2 inward(-in.y() * side, in.x() * side);
    const Point2 start = moved[i] - own * std::tan(std::abs(turn) / 2) * in;
    corners.push_back({.place = start + own * inward,
                       .radius = own,
                       .from = std::atan2(-inward.y(), -inward.x()),
                       .sweep = turn});
  }
  return corners;
}

std::vector<Point2> PointsOf(const std::vector<RoundedCorner>& corners, int per_turn, bool inside) {
  std::vector<Point2> points;
  for (const RoundedCorner& corner : corners) {
    if (corner.radius == 0) {
      points.push_back(corner.place);
      continue;
    }
    const auto at = [&](double share, double radius) {
      const double angle = corner.from + share * corner.sweep;
      points.emplace_back(corner.place + radius * Point2(std::cos(angle), std::sin(angle)));
    };
    const double turn = std::abs(corner.sweep);
    const int steps =
        std::max(1, static_cast<int>(std::ceil(turn * per_turn / (2 * std::numbers::pi) - 1e-9)));
    const bool is_outside = inside && corner.sweep < 0;
    at(0, corner.radius);
    // Corners of the circumscribed polygon are in the middle of the steps.
    for (int i = is_outside ? 0 : 1; i < steps; ++i) {
      if (is_outside)
        at((i + 0.5) / steps, corner.radius / std::cos(turn / steps / 2));
      else
        at(static_cast<double>(i) / steps, corner.radius);
    }
    at(1, corner.radius);
  }
  return points;
}

}  // namespace mjforge::solid
