#pragma once

// Closed outlines in a plane.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {

using Point = Eigen::Vector2d;

/// Corners counter-clockwise, and which of the input's points each comes from.
struct Outline {
  std::vector<Point> corners;
  std::vector<std::size_t> sources;

  std::size_t Next(std::size_t i) const { return i + 1 < corners.size() ? i + 1 : 0; }
  std::size_t Previous(std::size_t i) const { return i > 0 ? i - 1 : corners.size() - 1; }
  void Add(const Point& corner, std::size_t source);
  void Reverse();
};

inline double Cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Positive if counter-clockwise, m^2.
double AreaOf(std::span<const Point> corners);

/// The outline through the points, whichever way they go. Nothing, and a fault, if two neighbours
/// are equal, if it has no area, or if it crosses or touches itself.
std::optional<Outline> OutlineOf(std::span<const Point> points, Fault& fault);

/// The outline between a line in the half plane x >= 0 and its parallel at the distance `wall`
/// towards the y axis. A line that begins or ends on the axis is extended along it; other ends are
/// cut square.
std::optional<Outline> WalledOutline(std::span<const Point> line, double wall, Fault& fault);

}  // namespace mjforge::solid
