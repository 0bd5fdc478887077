#include "mjforge/solid/convex.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mjforge/solid/bridges.h"

namespace mjforge::solid {
namespace {

// Sine of a turn that is none.
constexpr double kStraight = 1e-12;

bool TurnsLeft(const Point& a, const Point& b, const Point& c, double least) {
  const Point in = b - a;
  const Point out = c - b;
  return Cross(in, out) >= least * in.norm() * out.norm();
}

/// Squared, and with few digits: what differs by rounding alone is taken in the order of the
/// corners, so that variants of one shape are cut alike.
float LengthOf(const Point& a, const Point& b) { return static_cast<float>((a - b).squaredNorm()); }

class EarClipper {
 public:
  /// `ring`: a loop of corners, which may come along the same place twice.
  EarClipper(const std::vector<Point>& corners, const std::vector<int>& ring)
      : corners_(corners), ring_(ring) {
    const std::size_t count = ring.size();
    for (std::size_t i = 0; i < count; ++i) {
      next_.push_back((i + 1) % count);
      previous_.push_back((i + count - 1) % count);
    }
    is_ear_.resize(count);
    left_.resize(count, true);
    for (std::size_t i = 0; i < count; ++i) is_ear_[i] = IsEar(i);
  }

  /// `cuts`: corners that a cut joins.
  std::vector<std::array<int, 3>> Run(std::vector<std::pair<int, int>>& cuts) {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t left = next_.size(); left > 3; --left) {
      const std::size_t ear = ShortestEar();
      const std::size_t before = previous_[ear];
      const std::size_t after = next_[ear];
      triangles.push_back({ring_[before], ring_[ear], ring_[after]});
      cuts.emplace_back(ring_[before], ring_[after]);
      left_[ear] = false;
      next_[before] = after;
      previous_[after] = before;
      is_ear_[before] = IsEar(before);
      is_ear_[after] = IsEar(after);
    }
    const std::size_t last = FirstLeft();
    triangles.push_back({ring_[previous_[last]], ring_[last], ring_[next_[last]]});
    return triangles;
  }

 private:
  const Point& At(std::size_t i) const { return corners_[static_cast<std::size_t>(ring_[i])]; }

  bool IsEar(std::size_t i) const {
    const Point& a = At(previous_[i]);
    const Point& b = At(i);
    const Point& c = At(next_[i]);
    if (!TurnsLeft(a, b, c, kStraight)) return false;
    for (std::size_t j = next_[next_[i]]; j != previous_[i]; j = next_[j]) {
      const Point& p = At(j);
      if (p == a || p == b || p == c) continue;
      if (Cross(b - a, p - a) >= 0 && Cross(c - b, p - b) >= 0 && Cross(a - c, p - c) >= 0)
        return false;
    }
    return true;
  }

  std::size_t FirstLeft() const {
    return static_cast<std::size_t>(std::ranges::find(left_, true) - left_.begin());
  }

  /// Rounding may leave none: then what turns left least.
  std::size_t ShortestEar() const {
    std::size_t shortest = FirstLeft();
    float length = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < next_.size(); ++i) {
      if (!left_[i] || !is_ear_[i]) continue;
      const float cut = LengthOf(At(next_[i]), At(previous_[i]));
      if (cut < length) {
        length = cut;
        shortest = i;
      }
    }
    return shortest;
  }

  const std::vector<Point>& corners_;
  const std::vector<int>& ring_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
  std::vector<bool> is_ear_;
  std::vector<bool> left_;
};

/// The polygon from behind `start` round to it.
std::vector<int> TurnedTo(std::vector<int> polygon, int start) {
  std::rotate(polygon.begin(), std::ranges::find(polygon, start), polygon.end());
  return polygon;
}

class Joiner {
 public:
  Joiner(const std::vector<Point>& corners, const std::vector<std::array<int, 3>>& triangles)
      : corners_(corners) {
    for (const std::array<int, 3>& triangle : triangles) {
      polygons_.emplace_back(triangle.begin(), triangle.end());
      Own(polygons_.size() - 1);
    }
  }

  /// Takes the cut from a to b away if that leaves a convex polygon.
  void Join(int a, int b) {
    const std::size_t one = owners_.at({a, b});
    const std::size_t other = owners_.at({b, a});
    std::vector<int> joined = TurnedTo(polygons_[one], b);          // b ... a
    const std::vector<int> second = TurnedTo(polygons_[other], a);  // a ... b
    const std::size_t at_a = joined.size() - 1;
    joined.insert(joined.end(), second.begin() + 1, second.end() - 1);
    if (!StaysConvex(joined, 0) || !StaysConvex(joined, at_a)) return;
    polygons_[one] = std::move(joined);
    polygons_[other].clear();
    Own(one);
  }

  std::vector<std::vector<int>> Take() {
    std::erase_if(polygons_, [](const auto& polygon) { return polygon.empty(); });
    return std::move(polygons_);
  }

 private:
  void Own(std::size_t polygon) {
    const std::vector<int>& corners = polygons_[polygon];
    for (std::size_t i = 0; i < corners.size(); ++i)
      owners_[{corners[i], corners[(i + 1) % corners.size()]}] = polygon;
  }

  const Point& At(int corner) const { return corners_[static_cast<std::size_t>(corner)]; }

  bool StaysConvex(const std::vector<int>& polygon, std::size_t i) const {
    const std::size_t count = polygon.size();
    return TurnsLeft(At(polygon[(i + count - 1) % count]), At(polygon[i]),
                     At(polygon[(i + 1) % count]), -kStraight);
  }

  const std::vector<Point>& corners_;
  std::vector<std::vector<int>> polygons_;
  std::map<std::pair<int, int>, std::size_t> owners_;  // of each side, by its corners
};

}  // namespace

Partition PartitionOf(const Area& area) {
  Partition partition;
  std::vector<std::pair<int, int>> cuts;
  const std::vector<int> ring = RingOf(area, cuts);
  partition.triangles = EarClipper(area.corners, ring).Run(cuts);
  const auto length = [&](const std::pair<int, int>& cut) {
    return LengthOf(area.corners[static_cast<std::size_t>(cut.first)],
                    area.corners[static_cast<std::size_t>(cut.second)]);
  };
  std::ranges::stable_sort(cuts, std::ranges::greater(), length);
  Joiner joiner(area.corners, partition.triangles);
  for (const auto& [a, b] : cuts) joiner.Join(b, a);
  partition.convex = joiner.Take();
  return partition;
}

bool IsConvex(const std::vector<Point>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!TurnsLeft(corners[i], corners[(i + 1) % count], corners[(i + 2) % count], -kStraight))
      return false;
  }
  return AreaOf(corners) > 0;
}

void RemoveStraightCorners(std::vector<Point>& corners) {
  std::vector<Point> kept;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (TurnsLeft(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count],
                  kStraight))
      kept.push_back(corners[i]);
  }
  corners = std::move(kept);
}

}  // namespace mjforge::solid
