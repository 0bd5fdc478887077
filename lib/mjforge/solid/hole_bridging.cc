// Hole bridging: connects each hole, rightmost first, to a visible corner of the outline or of an
// earlier hole.

#include "mjforge/solid/hole_bridging.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace mjforge::solid {
namespace {

class HoleBridger {
 public:
  explicit HoleBridger(const Area& area) : area_(area) {
    ring_.resize(area.ends.front());
    std::iota(ring_.begin(), ring_.end(), 0);
  }

  /// Inserts the detour around a hole, from its rightmost corner. Returns the bridge's two corners.
  std::pair<int, int> Add(std::size_t hole) {
    const auto [first, count] = area_.Loop(hole);
    const std::size_t start = Rightmost(hole);
    const std::size_t bridge = VisibleFrom(area_.corners[start]);
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
  const Point2& At(std::size_t i) const {
    return area_.corners[static_cast<std::size_t>(ring_[i % ring_.size()])];
  }

  /// Returns the position in `ring_` of a corner that is visible from `from`, the rightmost corner
  /// of a hole.
  std::size_t VisibleFrom(const Point2& from) const {
    // Finds the side that a ray to the right hits first.
    std::size_t side = 0;
    double x = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const std::optional<double> hit = RayHit(from, At(i), At(i + 1));
      if (hit && *hit < x) {
        x = *hit;
        side = i;
      }
    }
    const std::size_t next = (side + 1) % ring_.size();
    const std::size_t end = At(side).x() > At(next).x() ? side : next;
    return Nearest(from, Point2(x, from.y()), end);
  }

  /// Returns the x at which the ray from `from` along +x hits side ab of a polygon; nullopt if the
  /// ray misses the side, or if the side does not go upwards.
  static std::optional<double> RayHit(const Point2& from, const Point2& a, const Point2& b) {
    if (!(a.y() <= from.y() && b.y() >= from.y() && a.y() < b.y())) return std::nullopt;
    const double x = a.x() + (from.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    return x >= from.x() ? std::optional(x) : std::nullopt;
  }

  /// Returns `end` or, if corners of the loop are within the triangle `from`, `hit`, `end`, the
  /// corner with the smallest angle to the ray.
  std::size_t Nearest(const Point2& from, const Point2& hit, std::size_t end) const {
    const Point2 corner = At(end);
    if (corner == hit) return end;
    const bool is_up = corner.y() > from.y();
    const Point2& b = is_up ? hit : corner;
    const Point2& c = is_up ? corner : hit;
    std::size_t best = end;
    double slope = std::numeric_limits<double>::infinity();
    double length = slope;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Point2& p = At(i);
      if (p.x() <= from.x() || Turn(from, b, p) < 0 || Turn(b, c, p) < 0 || Turn(c, from, p) < 0)
        continue;
      if (!IsInCone(i, from)) continue;
      const Point2 bridge = p - from;
      const double tangent = std::abs(bridge.y()) / bridge.x();
      if (tangent > slope || (tangent == slope && bridge.x() >= length)) continue;
      slope = tangent;
      length = bridge.x();
      best = i;
    }
    return best;
  }

  /// Returns true if the line from corner i of the loop to `p` begins inside the loop.
  bool IsInCone(std::size_t i, const Point2& p) const {
    const Point2& a = At(i + ring_.size() - 1);
    const Point2& b = At(i);
    const Point2& c = At(i + 1);
    const bool left_of_in = Turn(a, b, p) > 0;
    const bool left_of_out = Turn(b, c, p) > 0;
    return Turn(a, b, c) >= 0 ? left_of_in && left_of_out : left_of_in || left_of_out;
  }

  const Area& area_;
  std::vector<int> ring_;
};

}  // namespace

std::vector<int> BridgeHoles(const Area& area, std::vector<std::pair<int, int>>& cuts) {
  HoleBridger bridger(area);
  std::vector<std::size_t> holes(area.ends.size() - 1);
  std::iota(holes.begin(), holes.end(), 1);
  // Begins with the rightmost hole, so that the ray of each hole hits a side that is already in the
  // loop.
  std::ranges::stable_sort(holes, std::ranges::greater(), [&](std::size_t hole) {
    return area.corners[bridger.Rightmost(hole)].x();
  });
  for (const std::size_t hole : holes) cuts.push_back(bridger.Add(hole));
  return bridger.Take();
}

}  // namespace mjforge::solid
