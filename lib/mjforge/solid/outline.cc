#include "mjforge/solid/outline.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mjforge::solid {
namespace {

// Of the size of the outline: what is nearer is a rounding apart.
constexpr double kRounding = 1e-12;

double SizeOf(std::span<const Point> points) {
  Eigen::AlignedBox2d box;
  for (const Point& point : points) box.extend(point);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

/// How near two segments come to each other, as far as it matters: 0 where they cross.
double DistanceBetween(const Point& a, const Point& b, const Point& c, const Point& d) {
  const bool apart = Turn(a, b, c) * Turn(a, b, d) > 0 || Turn(c, d, a) * Turn(c, d, b) > 0;
  const auto to_segment = [](const Point& p, const Point& from, const Point& to) {
    const Point way = to - from;
    const double share = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (from + share * way - p).norm();
  };
  const double ends = std::min(
      {to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
  return apart ? ends : std::min(ends, Turn(a, b, c) == 0 && Turn(a, b, d) == 0 ? ends : 0.0);
}

bool BoxesMeet(const Point& a, const Point& b, const Point& c, const Point& d, double around) {
  for (int i = 0; i < 2; ++i) {
    if (std::min(a[i], b[i]) > std::max(c[i], d[i]) + around) return false;
    if (std::min(c[i], d[i]) > std::max(a[i], b[i]) + around) return false;
  }
  return true;
}

/// The first two edges, by their first corners, that cross or touch without being neighbours, or
/// that are neighbours and go back on each other.
std::optional<std::pair<std::size_t, std::size_t>> Crossing(const Outline& outline, double size) {
  const std::vector<Point>& p = outline.corners;
  const double near = kRounding * size;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const std::size_t next = outline.Next(i);
    const Point in = p[next] - p[i];
    const Point out = p[outline.Next(next)] - p[next];
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

bool AreOnALine(std::span<const Point> points, double size) {
  return std::ranges::all_of(points, [&](const Point& p) {
    return std::abs(Turn(points[0], points[1], p)) <= kRounding * size * size;
  });
}

bool HasEqualNeighbours(std::span<const Point> points, bool closed, double size, Fault& fault) {
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const Point& before = points[i > 0 ? i - 1 : points.size() - 1];
    if ((points[i] - before).norm() > kRounding * size) continue;
    fault = {"is at the same place as the point before it", i};
    return true;
  }
  return false;
}

bool HasTooMany(std::span<const Point> points, std::size_t least, Fault& fault) {
  if (points.size() > kMostPoints) {
    fault = {fmt::format("has {} points, more than {}", points.size(), kMostPoints), std::nullopt};
  } else if (points.size() < least) {
    fault = {fmt::format("needs at least {} points", least), std::nullopt};
  }
  return points.size() > kMostPoints || points.size() < least;
}

// Left of the direction.
Point NormalOf(const Point& direction) { return Point(-direction.y(), direction.x()).normalized(); }

/// How far the corner between two directions moves if both lines move by `distance` to their left.
Point Mitre(const Point& in, const Point& out, double distance) {
  // |middle| is 2 cos(half the turn), the mitre is 1 / cos of it.
  const Point middle = NormalOf(in) + NormalOf(out);
  return 2 * distance / middle.squaredNorm() * middle;
}

/// The parallel of a line on its left, mitred at its corners.
std::vector<Point> ParallelOfLine(std::span<const Point> line, double distance) {
  std::vector<Point> parallel;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool first = i == 0;
    const bool last = i + 1 == line.size();
    const Point in = first ? Point(line[1] - line[0]) : Point(line[i] - line[i - 1]);
    const Point out = last ? in : Point(line[i + 1] - line[i]);
    parallel.emplace_back(line[i] + Mitre(in, out, distance));
    const bool on_axis = line[i].x() == 0;
    const Point along = first ? out : in;
    if ((first || last) && on_axis && along.x() != 0) {
      Point& end = parallel.back();
      end -= end.x() / along.x() * along;
      end.x() = 0;
    }
  }
  return parallel;
}

}  // namespace

void Outline::Add(const Point& corner, std::size_t source) {
  corners.push_back(corner);
  sources.push_back(source);
}

void Outline::Reverse() {
  std::ranges::reverse(corners);
  std::ranges::reverse(sources);
}

void Area::Add(const std::vector<Point>& loop) {
  corners.insert(corners.end(), loop.begin(), loop.end());
  ends.push_back(corners.size());
}

std::pair<std::size_t, std::size_t> Area::Loop(std::size_t i) const {
  const std::size_t first = i > 0 ? ends[i - 1] : 0;
  return {first, ends[i] - first};
}

double AreaOf(std::span<const Point> corners) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    twice += Turn(corners[0], corners[i], corners[i + 1]);
  }
  return twice / 2;
}

std::optional<Outline> OutlineOf(std::span<const Point> points, Fault& fault) {
  if (HasTooMany(points, 3, fault)) return std::nullopt;
  const double size = SizeOf(points);
  if (HasEqualNeighbours(points, true, size, fault)) return std::nullopt;
  if (AreOnALine(points, size)) {
    fault = {"has no area", std::nullopt};
    return std::nullopt;
  }
  Outline outline;
  for (std::size_t i = 0; i < points.size(); ++i) outline.Add(points[i], i);
  if (const auto crossing = Crossing(outline, size)) {
    const auto [first, second] = *crossing;
    fault = {CrossingText(first, second, outline), second};
    return std::nullopt;
  }
  if (AreaOf(points) < 0) outline.Reverse();
  return outline;
}

std::vector<Point> ParallelOf(const Outline& outline, double distance) {
  const std::vector<Point>& p = outline.corners;
  std::vector<Point> parallel;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point in = p[i] - p[outline.Previous(i)];
    const Point out = p[outline.Next(i)] - p[i];
    parallel.emplace_back(p[i] + Mitre(in, out, distance));
  }
  return parallel;
}

std::optional<std::size_t> Meeting(const Outline& a, const Outline& b) {
  const double near = kRounding * std::max(SizeOf(a.corners), SizeOf(b.corners));
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    const Point& from = a.corners[i];
    const Point& to = a.corners[a.Next(i)];
    for (std::size_t j = 0; j < b.corners.size(); ++j) {
      const Point& other = b.corners[j];
      const Point& end = b.corners[b.Next(j)];
      if (!BoxesMeet(from, to, other, end, near)) continue;
      if (DistanceBetween(from, to, other, end) <= near) return i;
    }
  }
  return std::nullopt;
}

bool Contains(const Outline& outline, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const Point& a = outline.corners[i];
    const Point& b = outline.corners[outline.Next(i)];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

std::optional<Outline> WalledOutline(std::span<const Point> line, double wall, Fault& fault) {
  if (HasTooMany(line, 2, fault)) return std::nullopt;
  const double size = SizeOf(line);
  if (HasEqualNeighbours(line, false, size, fault)) return std::nullopt;
  // The side of the axis is on the left if the line and the axis are counter-clockwise.
  std::vector<Point> closed(line.begin(), line.end());
  closed.emplace_back(0, line.back().y());
  closed.emplace_back(0, line.front().y());
  const double area = AreaOf(closed);
  if (!(std::abs(area) > kRounding * size * size)) {
    fault = {"has no inside: it is flat; give a closed outline without `wall`", std::nullopt};
    return std::nullopt;
  }
  Outline outline;
  for (std::size_t i = 0; i < line.size(); ++i) outline.Add(line[i], i);
  if (area < 0) outline.Reverse();
  const std::size_t count = line.size();
  const std::vector<Point> inside = ParallelOfLine(outline.corners, wall);
  for (std::size_t i = count; i-- > 0;) {
    if (inside[i].x() < 0) {
      fault = {fmt::format("is {:g} m from the axis: a wall of {:g} m is thicker",
                           outline.corners[i].x(), wall),
               outline.sources[i]};
      return std::nullopt;
    }
    outline.Add(inside[i], outline.sources[i]);
  }
  // Where it crosses itself, the wall is the cause, unless the line itself does.
  if (const auto crossing = Crossing(outline, size)) {
    const auto [first, second] = *crossing;
    const bool is_line = second + 1 < count;
    fault = {is_line ? CrossingText(first, second, outline)
                     : fmt::format("turns too sharply for a wall of {:g} m", wall),
             outline.sources[is_line ? second : outline.Next(second)]};
    return std::nullopt;
  }
  return outline;
}

}  // namespace mjforge::solid
