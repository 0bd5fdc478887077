// Validation of outlines (counts, repeats, crossings), offset outlines, walls along a line.

#include "mjforge/solid/outline.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mjforge::solid {
namespace {

// Distance, relative to the outline's size, below which points coincide.
constexpr double kRounding = 1e-12;

double SizeOf(std::span<const Point2> points) {
  const Eigen::AlignedBox2d box = BoxAround(points);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// Returns the distance between two segments, 0 if they cross.
double DistanceBetween(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const bool apart = Turn(a, b, c) * Turn(a, b, d) > 0 || Turn(c, d, a) * Turn(c, d, b) > 0;
  const double ends = std::min({DistanceToSegment(a, c, d), DistanceToSegment(b, c, d),
                                DistanceToSegment(c, a, b), DistanceToSegment(d, a, b)});
  return apart ? ends : std::min(ends, Turn(a, b, c) == 0 && Turn(a, b, d) == 0 ? ends : 0.0);
}

bool BoxesMeet(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double around) {
  for (int i = 0; i < 2; ++i) {
    if (std::min(a[i], b[i]) > std::max(c[i], d[i]) + around) return false;
    if (std::min(c[i], d[i]) > std::max(a[i], b[i]) + around) return false;
  }
  return true;
}

/// Returns the first corners of the first two sides that cross or touch without being neighbours,
/// or that are neighbours and turn back on each other.
std::optional<std::pair<std::size_t, std::size_t>> Crossing(const Outline& outline, double size) {
  const std::vector<Point2>& p = outline.corners;
  const double near = kRounding * size;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t next = outline.Next(i);
    const Point2 in = p[next] - p[i];
    const Point2 out = p[outline.Next(next)] - p[next];
    const bool turns_back =
        std::abs(Cross(in, out)) <= kRounding * in.norm() * out.norm() && in.dot(out) < 0;
    if (turns_back) return std::pair(i, next);
    for (std::size_t j = i + 2; j < p.size(); ++j) {
      const std::size_t after = outline.Next(j);
      if (after == i || !BoxesMeet(p[i], p[next], p[j], p[after], near)) continue;
      if (DistanceBetween(p[i], p[next], p[j], p[after]) <= near) return std::pair(i, j);
    }
  }
  return std::nullopt;
}

std::string CrossingText(std::size_t first, std::size_t second, const Outline& outline) {
  if (second == outline.Next(first)) return "turns back on the line before it";
  return fmt::format("begins a line that crosses or touches the one from point {} to point {}",
                     outline.sources[first] + 1, outline.sources[outline.Next(first)] + 1);
}

bool AreOnALine(std::span<const Point2> points, double size) {
  return std::ranges::all_of(points, [&](const Point2& p) {
    return std::abs(Turn(points[0], points[1], p)) <= kRounding * size * size;
  });
}

bool HasEqualNeighbours(std::span<const Point2> points, bool closed, double size, Fault& fault) {
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const Point2& before = points[i > 0 ? i - 1 : points.size() - 1];
    if ((points[i] - before).norm() > kRounding * size) continue;
    fault = {"is at the same place as the point before it", i};
    return true;
  }
  return false;
}

/// Returns the unit normal to the left of the direction.
Point2 LeftNormal(const Point2& direction) {
  return Point2(-direction.y(), direction.x()).normalized();
}

/// Returns the displacement of the corner between two lines that are moved by `distance` to their
/// left.
Point2 Mitre(const Point2& in, const Point2& out, double distance) {
  // With the turn t, |middle| = 2 cos(t / 2), and the mitre has the length distance / cos(t / 2).
  const Point2 middle = LeftNormal(in) + LeftNormal(out);
  return 2 * distance / middle.squaredNorm() * middle;
}

/// Returns the line's parallel at `distance` to its left, with mitred corners. Ends on the axis
/// stay on the axis.
std::vector<Point2> ParallelOfLine(std::span<const Point2> line, double distance) {
  std::vector<Point2> parallel;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool first = i == 0;
    const bool last = i + 1 == line.size();
    const Point2 in = first ? Point2(line[1] - line[0]) : Point2(line[i] - line[i - 1]);
    const Point2 out = last ? in : Point2(line[i + 1] - line[i]);
    parallel.emplace_back(line[i] + Mitre(in, out, distance));
    const bool on_axis = line[i].x() == 0;
    const Point2 along = first ? out : in;
    if ((first || last) && on_axis && along.x() != 0) {
      Point2& end = parallel.back();
      end -= end.x() / along.x() * along;
      end.x() = 0;
    }
  }
  return parallel;
}

}  // namespace

void Outline::Add(const Point2& corner, std::size_t source) {
  corners.push_back(corner);
  sources.push_back(source);
}

void Outline::Reverse() {
  std::ranges::reverse(corners);
  std::ranges::reverse(sources);
}

void Area::Add(const std::vector<Point2>& loop) {
  corners.insert(corners.end(), loop.begin(), loop.end());
  ends.push_back(corners.size());
}

std::pair<std::size_t, std::size_t> Area::Loop(std::size_t i) const {
  const std::size_t first = i > 0 ? ends[i - 1] : 0;
  return {first, ends[i] - first};
}

bool HasBadCount(std::size_t count, std::size_t least, Fault& fault) {
  if (count > kMostPoints) {
    Fail(fault, fmt::format("has {} points, more than {}", count, kMostPoints));
  } else if (count < least) {
    Fail(fault, fmt::format("needs at least {} points", least));
  }
  return count > kMostPoints || count < least;
}

std::optional<Outline> OutlineOf(std::span<const Point2> points, Fault& fault) {
  if (HasBadCount(points.size(), 3, fault)) return std::nullopt;
  const double size = SizeOf(points);
  if (HasEqualNeighbours(points, true, size, fault)) return std::nullopt;
  if (AreOnALine(points, size)) return Fail(fault, "has no area");
  Outline outline;
  for (std::size_t i = 0; i < points.size(); ++i) outline.Add(points[i], i);
  if (const auto crossing = Crossing(outline, size)) {
    const auto [first, second] = *crossing;
    return Fail(fault, CrossingText(first, second, outline), second);
  }
  if (AreaOf(points) < 0) outline.Reverse();
  return outline;
}

std::vector<Point2> ParallelOf(const Outline& outline, double distance) {
  const std::vector<Point2>& p = outline.corners;
  std::vector<Point2> parallel;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point2 in = p[i] - p[outline.Previous(i)];
    const Point2 out = p[outline.Next(i)] - p[i];
    parallel.emplace_back(p[i] + Mitre(in, out, distance));
  }
  return parallel;
}

std::optional<std::size_t> FirstContact(const Outline& a, const Outline& b) {
  const double near = kRounding * std::max(SizeOf(a.corners), SizeOf(b.corners));
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    const Point2& from = a.corners[i];
    const Point2& to = a.corners[a.Next(i)];
    for (std::size_t j = 0; j < b.corners.size(); ++j) {
      const Point2& other = b.corners[j];
      const Point2& end = b.corners[b.Next(j)];
      if (!BoxesMeet(from, to, other, end, near)) continue;
      if (DistanceBetween(from, to, other, end) <= near) return i;
    }
  }
  return std::nullopt;
}

bool Contains(const Outline& outline, const Point2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const Point2& a = outline.corners[i];
    const Point2& b = outline.corners[outline.Next(i)];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

std::optional<Outline> WalledOutline(std::span<const Point2> line, double wall, Fault& fault) {
  if (HasBadCount(line.size(), 2, fault)) return std::nullopt;
  const double size = SizeOf(line);
  if (HasEqualNeighbours(line, false, size, fault)) return std::nullopt;
  // The axis is to the left of the line if the line, closed along the axis, is counter-clockwise.
  std::vector<Point2> closed(line.begin(), line.end());
  closed.emplace_back(0, line.back().y());
  closed.emplace_back(0, line.front().y());
  const double area = AreaOf(closed);
  if (!(std::abs(area) > kRounding * size * size))
    return Fail(fault, "has no inside: it is flat; give a closed outline without `wall`");
  Outline outline;
  for (std::size_t i = 0; i < line.size(); ++i) outline.Add(line[i], i);
  if (area < 0) outline.Reverse();
  const std::size_t count = line.size();
  const std::vector<Point2> inside = ParallelOfLine(outline.corners, wall);
  for (std::size_t i = count; i-- > 0;) {
    if (inside[i].x() < 0)
      return Fail(fault,
                  fmt::format("is {:g} m from the axis: a wall of {:g} m is thicker",
                              outline.corners[i].x(), wall),
                  outline.sources[i]);
    outline.Add(inside[i], outline.sources[i]);
  }
  // If the outline crosses itself but the line does not, the wall is too thick.
  if (const auto crossing = Crossing(outline, size)) {
    const auto [first, second] = *crossing;
    const bool is_line = second + 1 < count;
    return Fail(fault,
                is_line ? CrossingText(first, second, outline)
                        : fmt::format("turns too sharply for a wall of {:g} m", wall),
                outline.sources[is_line ? second : outline.Next(second)]);
  }
  return outline;
}

}  // namespace mjforge::solid
