// Closed outlines in a plane: validation, offset, containment.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {

/// A closed polygon, and for each corner the index of the input point from which it was made.
struct Outline {
  std::vector<Point2> corners;
  std::vector<std::size_t> sources;

  std::size_t Next(std::size_t i) const { return i + 1 < corners.size() ? i + 1 : 0; }
  std::size_t Previous(std::size_t i) const { return i > 0 ? i - 1 : corners.size() - 1; }
  void Add(const Point2& corner, std::size_t source);
  void Reverse();
};

/// A polygon with holes: the outline counter-clockwise, followed by the holes clockwise.
struct Area {
  std::vector<Point2> corners;
  std::vector<std::size_t> ends;  // for each loop, the index after its last corner

  Area() = default;
  explicit Area(const std::vector<Point2>& loop) { Add(loop); }
  void Add(const std::vector<Point2>& loop);
  /// Returns the index of the first corner of loop i, and the number of its corners.
  std::pair<std::size_t, std::size_t> Loop(std::size_t i) const;
};

/// Returns true and sets `fault` if there are fewer than `least` or more than kMostPoints points.
bool HasBadCount(std::size_t count, std::size_t least, Fault& fault);

/// Returns the counter-clockwise outline through points given in either direction. Returns nullopt
/// and sets `fault` if two neighbouring points are equal, or if the outline has no area, crosses
/// itself or touches itself.
std::optional<Outline> OutlineOf(std::span<const Point2> points, Fault& fault);

/// Returns the outline's corners after each side is moved by `distance`, m, to its left.
std::vector<Point2> ParallelOf(const Outline& outline, double distance);

/// Returns the index of the first side of `a` that crosses or touches a side of `b`; nullopt if
/// none does. Side i begins at corner i.
std::optional<std::size_t> FirstContact(const Outline& a, const Outline& b);

/// Returns true if the point is inside the outline, up to rounding errors.
bool Contains(const Outline& outline, const Point2& p);

/// Returns the outline between a line in the half plane x >= 0 and its parallel at the distance
/// `wall` towards the y axis. At an end on the y axis the outline follows the axis; other ends are
/// cut perpendicular to the line. Returns nullopt and sets `fault` if the wall is too thick or the
/// line is faulty.
std::optional<Outline> WalledOutline(std::span<const Point2> line, double wall, Fault& fault);

}  // namespace mjforge::solid
