#include "mjforge/solid/look.h"

#include <algorithm>
#include <cmath>

namespace mjforge::solid {
namespace {

constexpr double kLevelNormal = 1e-9;  // its part across the axis

/// A circle of vertices.
struct Ring {
  Point place;
  Point normal;  // r, z
  double along = 0;
  bool level = false;   // of a disc, which gets its picture from above
  int first = 0;        // of its vertices
  bool single = false;  // a point of the axis with one vertex
  bool is_tip() const { return place.x() == 0; }
};

Point OutwardOf(const Point& from, const Point& to) {
  const Point way = to - from;
  return Point(way.y(), -way.x()).normalized();
}

/// How far each point is along the line, m, and behind the last the whole way round.
std::vector<double> Lengths(const std::vector<Point>& line, bool closed) {
  std::vector<double> lengths = {0};
  const std::size_t count = line.size();
  for (std::size_t i = 1; i < count + (closed ? 1 : 0); ++i)
    lengths.push_back(lengths.back() + (line[i % count] - line[i - 1]).norm());
  if (!closed) lengths.push_back(lengths.back());
  return lengths;
}

/// Makes texture coordinates of the lengths along; returns that of a whole turn.
double LayOn(const Texture& texture, const std::vector<Point>& line, std::vector<double>& along) {
  // A picture's rows are counted from its top.
  const double length = along.back();
  double radius = 0;
  for (const Point& p : line) radius = std::max(radius, p.x());
  const bool by_metre = texture.unit == Texture::Unit::kMetre;
  const double scale = texture.repeat.y() / (by_metre ? 1 : length);
  for (double& number : along) number = (length - number) * scale;
  return texture.repeat.x() * (by_metre ? kWholeTurn * radius : 1);
}

class Looker {
 public:
  explicit Looker(const TurnedLook& input) : in_(input) {
    if (in_.texture.unit != Texture::Unit::kNone) {
      along_ = Lengths(in_.line, in_.is_closed);
      around_ = LayOn(in_.texture, in_.line, along_);
    }
    Eigen::AlignedBox2d box;
    for (const Point& p : in_.outline.corners) box.extend(p);
    const double half_size = std::max(box.max().x(), box.sizes().y() / 2);
    const double per_turn = SegmentsOf(box.max().x(), ChordError(half_size), in_.angle);
    segments_ = std::max(3, static_cast<int>(std::ceil(per_turn * in_.angle / kWholeTurn - 1e-9)));
    closes_ = in_.angle == kWholeTurn && along_.empty();
    for (int i = 0; i <= 2 * segments_; ++i) {
      const double turn = i == 2 * segments_ && in_.angle == kWholeTurn ? 0 : TurnOf(0.5 * i);
      ways_.emplace_back(std::cos(turn), std::sin(turn));
    }
  }

  Surface Run() {
    const std::size_t count = in_.outline.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!IsSeen(i)) continue;
      // The ring where the edge before this one ended, if nothing sets them apart.
      const int from = !starts_.empty() && last_corner_ == i ? JoinedTo(i) : AddRing(i, i);
      const int to = AddRing(in_.outline.Next(i), i);
      starts_.emplace_back(from, to);
      last_corner_ = in_.outline.Next(i);
    }
    CloseRound();
    for (Ring& ring : rings_) AddVertices(ring);
    for (const auto& [from, to] : starts_) AddBand(from, to);
    if (in_.angle != kWholeTurn) AddEnds();
    return std::move(surface_);
  }

 private:
  const Point& At(std::size_t i) const { return in_.outline.corners[i]; }

  double TurnOf(double segments) const { return segments / segments_ * in_.angle; }

  /// Whether the edge behind a corner is more than a piece of the axis.
  bool IsSeen(std::size_t edge) const {
    return At(edge).x() != 0 || At(in_.outline.Next(edge)).x() != 0;
  }

  Point NormalOf(std::size_t edge) const { return OutwardOf(At(edge), At(in_.outline.Next(edge))); }

  /// Texture coordinate of a corner as an end of an edge.
  double Along(std::size_t corner, std::size_t edge) const {
    if (along_.empty()) return 0;
    const std::vector<std::size_t>& sources = in_.outline.sources;
    const std::size_t a = sources[edge];
    const std::size_t b = sources[in_.outline.Next(edge)];
    const bool closes = std::max(a, b) - std::min(a, b) > 1;  // from the last point to the first
    return closes && sources[corner] == 0 ? along_.back() : along_[sources[corner]];
  }

  int AddRing(std::size_t corner, std::size_t edge) { return Add(RingOf(corner, edge)); }

  Ring RingOf(std::size_t corner, std::size_t edge) const {
    const Point normal = NormalOf(edge);
    const bool is_level = std::abs(normal.x()) < kLevelNormal;
    return {At(corner), normal, Along(corner, edge),
            is_level && in_.texture.unit == Texture::Unit::kMetre};
  }

  int Add(const Ring& ring) {
    rings_.push_back(ring);
    return static_cast<int>(rings_.size()) - 1;
  }

  /// Gives both one normal, if the crease lets them be seen as one. Whether they can be one.
  bool Smooth(Ring& a, Ring& b) const {
    if (a.normal.dot(b.normal) < std::cos(in_.crease) || a.is_tip()) return false;
    a.normal = b.normal = (a.normal + b.normal).normalized();
    return a.along == b.along && a.level == b.level;
  }

  int JoinedTo(std::size_t edge) {
    const int before = starts_.back().second;
    Ring next = RingOf(edge, edge);
    return Smooth(rings_[static_cast<std::size_t>(before)], next) ? before : Add(next);
  }

  /// The last edge may go on smoothly in the first.
  void CloseRound() {
    if (last_corner_ != 0 || !IsSeen(0)) return;
    auto& [first, unused] = starts_.front();
    const auto last = static_cast<std::size_t>(starts_.back().second);
    if (!Smooth(rings_[static_cast<std::size_t>(first)], rings_[last])) return;
    starts_.back().second = first;
    rings_.pop_back();
  }

  void AddVertices(Ring& ring) {
    ring.first = static_cast<int>(surface_.vertices.size());
    Point normal = ring.normal;
    if (ring.is_tip() && std::abs(normal.y()) >= std::cos(in_.crease)) {
      ring.single = along_.empty() || ring.level;
      normal = Point(0, std::copysign(1, normal.y()));
    }
    const int count = ring.single ? 1 : ring.is_tip() || closes_ ? segments_ : segments_ + 1;
    for (int i = 0; i < count; ++i) {
      const int halves = ring.single ? 0 : 2 * i + (ring.is_tip() ? 1 : 0);
      const Point& way = ways_[static_cast<std::size_t>(halves)];
      const double r = ring.place.x();
      surface_.vertices.emplace_back(r * way.x(), r * way.y(), ring.place.y());
      surface_.normals.emplace_back(normal.x() * way.x(), normal.x() * way.y(), normal.y());
      if (!along_.empty()) surface_.texcoords.push_back(TexcoordOf(ring, halves));
    }
  }

  Point TexcoordOf(const Ring& ring, int halves) const {
    if (!ring.level) return {TurnOf(0.5 * halves) / kWholeTurn * around_, ring.along};
    const Point& way = ways_[static_cast<std::size_t>(halves)];
    return (ring.place.x() * Point(way.x(), -way.y())).cwiseProduct(in_.texture.repeat);
  }

  void AddBand(int from, int to) {
    const Ring& a = rings_[static_cast<std::size_t>(from)];
    const Ring& b = rings_[static_cast<std::size_t>(to)];
    for (int i = 0; i < segments_; ++i) {
      const int next = closes_ && i + 1 == segments_ ? 0 : i + 1;
      const int at_a = a.first + (a.single ? 0 : i);
      const int at_b = b.first + (b.single ? 0 : i);
      if (a.is_tip())
        surface_.triangles.push_back({at_a, b.first + next, at_b});
      else if (b.is_tip())
        surface_.triangles.push_back({at_a, a.first + next, at_b});
      else
        AddQuad(at_a, a.first + next, b.first + next, at_b, surface_);
    }
  }

  /// The outline itself, where the turn begins and ends.
  void AddEnds() {
    for (const double turn : {0.0, in_.angle}) {
      const int first = static_cast<int>(surface_.vertices.size());
      const double c = std::cos(turn);
      const double s = std::sin(turn);
      const double sign = turn == 0 ? -1 : 1;
      for (const Point& p : in_.outline.corners) {
        surface_.vertices.emplace_back(p.x() * c, p.x() * s, p.y());
        surface_.normals.emplace_back(-sign * s, sign * c, 0);
        if (!along_.empty()) surface_.texcoords.emplace_back(p);
      }
      for (std::array<int, 3> triangle : in_.partition.triangles) {
        if (turn != 0) std::swap(triangle[1], triangle[2]);
        for (int& corner : triangle) corner += first;
        surface_.triangles.push_back(triangle);
      }
    }
  }

  const TurnedLook& in_;
  std::vector<double> along_;  // texture coordinates of the line's points; empty: there are none
  double around_ = 1;          // the one at the end of a whole turn
  int segments_ = 0;
  bool closes_ = false;      // the last segment ends at the vertices where the first begins
  std::vector<Point> ways_;  // cosine and sine at each half segment
  Surface surface_;
  std::vector<Ring> rings_;
  std::vector<std::pair<int, int>> starts_;  // rings of each edge that is seen
  std::size_t last_corner_ = 0;              // where the last of them ends
};

}  // namespace

Surface Make(const TurnedLook& look) {
  Surface surface = Looker(look).Run();
  RoundForText(surface);
  return surface;
}

}  // namespace mjforge::solid
