// Convex partition of an area: ear clipping, and merging of triangles into convex polygons.

#include "mjforge/solid/convex_partition.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mjforge/solid/hole_bridging.h"

namespace mjforge::solid {
namespace {

/// Returns true if the sine of the turn at b, positive to the left, is at least `least`.
bool TurnsLeft(const Point2& a, const Point2& b, const Point2& c, double least) {
  const Point2 in = b - a;
  const Point2 out = c - b;
  return Cross(in, out) >= least * in.norm() * out.norm();
}

/// Returns the squared length in single precision, so that lengths that differ by rounding errors
/// alone are equal and variants of one shape are cut in the same order.
float LengthOf(const Point2& a, const Point2& b) {
  return static_cast<float>((a - b).squaredNorm());
}

class EarClipper {
 public:
  /// `ring` is a loop of corners and can contain a corner twice, at both ends of a bridge.
  EarClipper(const std::vector<Point2>& corners, const std::vector<int>& ring)
      : corners_(corners), ring_(ring) {
    const std::size_t count = ring.size();
    for (std::size_t i = 0; i < count; ++i) {
      next_.push_back((i + 1) % count);
      previous_.push_back((i + count - 1) % count);
    }
    is_ear_.resize(count);
    remaining_.resize(count, true);
    for (std::size_t i = 0; i < count; ++i) is_ear_[i] = IsEar(i);
  }

  /// Returns the triangles, and adds the pairs of corners that are joined by a cut to `cuts`.
  std::vector<std::array<int, 3>> Run(std::vector<std::pair<int, int>>& cuts) {
    std::vector<std::array<int, 3>> triangles;
    for (std::size_t remaining = next_.size(); remaining > 3; --remaining) {
      const std::size_t ear = ShortestEar();
      const std::size_t before = previous_[ear];
      const std::size_t after = next_[ear];
      triangles.push_back({ring_[before], ring_[ear], ring_[after]});
      cuts.emplace_back(ring_[before], ring_[after]);
      remaining_[ear] = false;
      next_[before] = after;
      previous_[after] = before;
      is_ear_[before] = IsEar(before);
      is_ear_[after] = IsEar(after);
    }
    const std::size_t last = FirstRemaining();
    triangles.push_back({ring_[previous_[last]], ring_[last], ring_[next_[last]]});
    return triangles;
  }

 private:
  const Point2& At(std::size_t i) const { return corners_[static_cast<std::size_t>(ring_[i])]; }

  bool IsEar(std::size_t i) const {
    const Point2& a = At(previous_[i]);
    const Point2& b = At(i);
    const Point2& c = At(next_[i]);
    if (!TurnsLeft(a, b, c, kStraight)) return false;
    for (std::size_t j = next_[next_[i]]; j != previous_[i]; j = next_[j]) {
      const Point2& p = At(j);
      if (p == a || p == b || p == c) continue;
      if (Cross(b - a, p - a) >= 0 && Cross(c - b, p - b) >= 0 && Cross(a - c, p - c) >= 0)
        return false;
    }
    return true;
  }

  std::size_t FirstRemaining() const {
    return static_cast<std::size_t>(std::ranges::find(remaining_, true) - remaining_.begin());
  }

  /// Returns the ear with the shortest cut, or the first remaining corner if rounding errors leave
  /// no ear.
  std::size_t ShortestEar() const {
    std::size_t shortest = FirstRemaining();
    float length = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < next_.size(); ++i) {
      if (!remaining_[i] || !is_ear_[i]) continue;
      const float cut = LengthOf(At(next_[i]), At(previous_[i]));
      if (cut < length) {
        length = cut;
        shortest = i;
      }
    }
    return shortest;
  }

  const std::vector<Point2>& corners_;
  const std::vector<int>& ring_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
  std::vector<bool> is_ear_;
  std::vector<bool> remaining_;
};

/// Rotates the polygon so that it begins at `start`.
std::vector<int> RotatedTo(std::vector<int> polygon, int start) {
  std::rotate(polygon.begin(), std::ranges::find(polygon, start), polygon.end());
  return polygon;
}

class PolygonMerger {
 public:
  PolygonMerger(const std::vector<Point2>& corners,
                const std::vector<std::array<int, 3>>& triangles)
      : corners_(corners) {
    for (const std::array<int, 3>& triangle : triangles) {
      polygons_.emplace_back(triangle.begin(), triangle.end());
      Own(polygons_.size() - 1);
    }
  }

  /// Merges the two polygons that share the edge ab if the result is convex.
  void Merge(int a, int b) {
    const std::size_t one = owners_.at({a, b});
    const std::size_t other = owners_.at({b, a});
    std::vector<int> merged = RotatedTo(polygons_[one], b);          // b ... a
    const std::vector<int> second = RotatedTo(polygons_[other], a);  // a ... b
    const std::size_t at_a = merged.size() - 1;
    merged.insert(merged.end(), second.begin() + 1, second.end() - 1);
    if (!StaysConvex(merged, 0) || !StaysConvex(merged, at_a)) return;
    polygons_[one] = std::move(merged);
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

  const Point2& At(int corner) const { return corners_[static_cast<std::size_t>(corner)]; }

  bool StaysConvex(const std::vector<int>& polygon, std::size_t i) const {
    const std::size_t count = polygon.size();
    return TurnsLeft(At(polygon[(i + count - 1) % count]), At(polygon[i]),
                     At(polygon[(i + 1) % count]), -kStraight);
  }

  const std::vector<Point2>& corners_;
  std::vector<std::vector<int>> polygons_;
  std::map<std::pair<int, int>, std::size_t> owners_;  // index of the polygon to the left of a side
};

}  // namespace

ConvexPartition PartitionOf(const Area& area) {
  ConvexPartition partition;
  std::vector<std::pair<int, int>> cuts;
  const std::vector<int> ring = BridgeHoles(area, cuts);
  partition.triangles = EarClipper(area.corners, ring).Run(cuts);
  const auto length = [&](const std::pair<int, int>& cut) {
    return LengthOf(area.corners[static_cast<std::size_t>(cut.first)],
                    area.corners[static_cast<std::size_t>(cut.second)]);
  };
  std::ranges::stable_sort(cuts, std::ranges::greater(), length);
  PolygonMerger merger(area.corners, partition.triangles);
  for (const auto& [a, b] : cuts) merger.Merge(b, a);
  partition.convex = merger.Take();
  return partition;
}

std::vector<std::vector<Point2>> MergedPolygonsOf(const Area& area) {
  std::vector<std::vector<Point2>> polygons;
  for (const std::vector<int>& polygon : PartitionOf(area).convex)
    RemoveStraightCorners(polygons.emplace_back(PointsAt(area.corners, polygon)));
  return polygons;
}

bool IsConvex(const std::vector<Point2>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!TurnsLeft(corners[i], corners[(i + 1) % count], corners[(i + 2) % count], -kStraight))
      return false;
  }
  return AreaOf(corners) > 0;
}

void RemoveStraightCorners(std::vector<Point2>& corners) {
  std::vector<Point2> kept;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (TurnsLeft(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count],
                  kStraight))
      kept.push_back(corners[i]);
  }
  corners = std::move(kept);
}

}  // namespace mjforge::solid
