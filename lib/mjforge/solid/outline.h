#pragma once

// Closed outlines in a plane.

#include <optional>
#include <span>
#include <string>
#include <utility>
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

/// A plane area: its outline counter-clockwise, then holes in it clockwise.
struct Area {
  std::vector<Point> corners;
  std::vector<std::size_t> ends;  // where each loop's corners end

  Area() = default;
  explicit Area(const std::vector<Point>& loop) { Add(loop); }
  void Add(const std::vector<Point>& loop);
  /// First corner and number of corners of a loop.
  std::pair<std::size_t, std::size_t> Loop(std::size_t i) const;
};

inline double Cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the area of the triangle, positive if it is counter-clockwise.
inline double Turn(const Point& a, const Point& b, const Point& c) { return Cross(b - a, c - a); }

/// Positive if counter-clockwise, m^2.
double AreaOf(std::span<const Point> corners);

/// The outline through the points, whichever way they go. Nothing, and a fault, if two neighbours
/// are equal, if it has no area, or if it crosses or touches itself.
std::optional<Outline> OutlineOf(std::span<const Point> points, Fault& fault);

/// The same outline with each side moved by `distance` to its left, m.
std::vector<Point> ParallelOf(const Outline& outline, double distance);

/// The first side of `a`, by its first corner, that crosses or touches one of `b`.
std::optional<std::size_t> Meeting(const Outline& a, const Outline& b);

/// Whether the point is inside, up to rounding.
bool Contains(const Outline& outline, const Point& p);

/// The outline between a line in the half plane x >= 0 and its parallel at the distance `wall`
/// towards the y axis. A line that begins or ends on the axis is extended along it; other ends are
/// cut square.
std::optional<Outline> WalledOutline(std::span<const Point> line, double wall, Fault& fault);

}  // namespace mjforge::solid
