#include "mjforge/solid/bridges.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace mjforge::solid {
namespace {

class Bridger {
 public:
  explicit Bridger(const Area& area) : area_(area) {
    ring_.resize(area.ends.front());
    std::iota(ring_.begin(), ring_.end(), 0);
  }

  /// Goes from the ring into a hole at its rightmost corner, and back.
  std::pair<int, int> Add(std::size_t hole) {
    const auto [first, count] = area_.Loop(hole);
    const std::size_t start = Rightmost(hole);
    const std::size_t bridge = Facing(area_.corners[start]);
    std::vector<int> detour;
    for (std::size_t i = 0; i <= count; ++i)
      detour.push_back(static_cast<int>(first + (start - first + i) % count));
    const int corner = ring_[bridge];
    detour.push_back(corner);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(bridge) + 1, detour.begin(),
                 detour.end());
    return {static_cast<int>(start), corner};
  }

  std::size_t Rightmost(std::size_t hole) const {
    const auto [first, count] = area_.Loop(hole);
    std::size_t best = first;
    for (std::size_t i = first; i < first + count; ++i) {
      if (area_.corners[i].x() > area_.corners[best].x()) best = i;
    }
    return best;
  }

  std::vector<int> Take() { return std::move(ring_); }

 private:
  const Point& At(std::size_t i) const {
    return area_.corners[static_cast<std::size_t>(ring_[i % ring_.size()])];
  }

  /// The place in the ring of a corner that can be seen from `from`, a corner of a hole that all
  /// others are left of.
  std::size_t Facing(const Point& from) const {
    // The side that the ray to the right meets first.
    std::size_t side = 0;
    double x = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const std::optional<double> meeting = Meeting(from, At(i), At(i + 1));
      if (meeting && *meeting < x) {
        x = *meeting;
        side = i;
      }
    }
    const std::size_t next = (side + 1) % ring_.size();
    const std::size_t end = At(side).x() > At(next).x() ? side : next;
    return Nearest(from, Point(x, from.y()), end);
  }

  /// Where a side of the ring that goes up meets the ray.
  static std::optional<double> Meeting(const Point& from, const Point& a, const Point& b) {
    if (!(a.y() <= from.y() && b.y() >= from.y() && a.y() < b.y())) return std::nullopt;
    const double x = a.x() + (from.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    return x >= from.x() ? std::optional(x) : std::nullopt;
  }

  /// `end`, unless corners of the ring lie in the triangle: then the one nearest to the ray.
  std::size_t Nearest(const Point& from, const Point& meeting, std::size_t end) const {
    const Point corner = At(end);
    if (corner == meeting) return end;
    const bool is_up = corner.y() > from.y();
    const Point& b = is_up ? meeting : corner;
    const Point& c = is_up ? corner : meeting;
    std::size_t best = end;
    double slope = std::numeric_limits<double>::infinity();
    double length = slope;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Point& p = At(i);
      if (p.x() <= from.x() || Turn(from, b, p) < 0 || Turn(b, c, p) < 0 || Turn(c, from, p) < 0)
        continue;
      if (!IsInCone(i, from)) continue;
      const Point way = p - from;
      const double tangent = std::abs(way.y()) / way.x();
      if (tangent > slope || (tangent == slope && way.x() >= length)) continue;
      slope = tangent;
      length = way.x();
      best = i;
    }
    return best;
  }

  /// Whether the way from a corner of the ring to a point begins inside of the ring.
  bool IsInCone(std::size_t i, const Point& p) const {
    const Point& a = At(i + ring_.size() - 1);
    const Point& b = At(i);
    const Point& c = At(i + 1);
    const bool left_of_in = Turn(a, b, p) > 0;
    const bool left_of_out = Turn(b, c, p) > 0;
    return Turn(a, b, c) >= 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }

  const Area& area_;
  std::vector<int> ring_;
};

}  // namespace

std::vector<int> RingOf(const Area& area, std::vector<std::pair<int, int>>& cuts) {
  Bridger bridger(area);
  std::vector<std::size_t> holes(area.ends.size() - 1);
  std::iota(holes.begin(), holes.end(), 1);
  // The rightmost first: what its ray meets is in the ring already.
  std::ranges::stable_sort(holes, std::ranges::greater(), [&](std::size_t hole) {
    return area.corners[bridger.Rightmost(hole)].x();
  });
  for (const std::size_t hole : holes) cuts.push_back(bridger.Add(hole));
  return bridger.Take();
}

}  // namespace mjforge::solid
