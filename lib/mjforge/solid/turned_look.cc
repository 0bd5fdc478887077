#include "mjforge/solid/look.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mjforge::solid {
namespace {

constexpr double kSegments = 48;  // a whole turn

/// A circle of vertices.
struct Ring {
  Point place;
  Point normal;  // r, z
  double along = 0;
  int first = 0;      // of its vertices
  bool flat = false;  // a point of the axis in an even surface
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
  return texture.repeat.x() * (by_metre ? 2 * std::numbers::pi * radius : 1);
}

class Looker {
 public:
  explicit Looker(const TurnedLook& input) : in_(input) {
    constexpr double kWhole = 2 * std::numbers::pi;
    along_ = Lengths(in_.line, in_.is_closed);
    around_ = LayOn(in_.texture, in_.line, along_);
    segments_ = std::max(3, static_cast<int>(std::ceil(kSegments * in_.angle / kWhole - 1e-9)));
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
    if (in_.angle != 2 * std::numbers::pi) AddEnds();
    return std::move(surface_);
  }

 private:
  const Point& At(std::size_t i) const { return in_.outline.corners[i]; }

  /// Whether the edge behind a corner is more than a piece of the axis.
  bool IsSeen(std::size_t edge) const {
    return At(edge).x() != 0 || At(in_.outline.Next(edge)).x() != 0;
  }

  Point NormalOf(std::size_t edge) const { return OutwardOf(At(edge), At(in_.outline.Next(edge))); }

  /// Texture coordinate of a corner as an end of an edge.
  double Along(std::size_t corner, std::size_t edge) const {
    const std::vector<std::size_t>& sources = in_.outline.sources;
    const std::size_t a = sources[edge];
    const std::size_t b = sources[in_.outline.Next(edge)];
    const bool closes = std::max(a, b) - std::min(a, b) > 1;  // from the last point to the first
    return closes && sources[corner] == 0 ? along_.back() : along_[sources[corner]];
  }

  int AddRing(std::size_t corner, std::size_t edge) {
    rings_.push_back({At(corner), NormalOf(edge), Along(corner, edge)});
    return static_cast<int>(rings_.size()) - 1;
  }

  bool AreOne(const Ring& a, const Ring& b) const {
    return a.along == b.along && a.normal.dot(b.normal) >= std::cos(in_.crease) && !a.is_tip();
  }

  int JoinedTo(std::size_t edge) {
    const int before = starts_.back().second;
    Ring& ring = rings_[static_cast<std::size_t>(before)];
    const Ring next = {At(edge), NormalOf(edge), Along(edge, edge)};
    if (!AreOne(ring, next)) return AddRing(edge, edge);
    ring.normal = (ring.normal + next.normal).normalized();
    return before;
  }

  /// The last edge may go on smoothly in the first.
  void CloseRound() {
    if (last_corner_ != 0 || !IsSeen(0)) return;
    auto& [first, unused] = starts_.front();
    const auto last = static_cast<std::size_t>(starts_.back().second);
    Ring& ring = rings_[static_cast<std::size_t>(first)];
    if (!AreOne(ring, rings_[last])) return;
    ring.normal = (ring.normal + rings_[last].normal).normalized();
    starts_.back().second = first;
    rings_.pop_back();
  }

  void AddVertices(Ring& ring) {
    ring.first = static_cast<int>(surface_.vertices.size());
    Point normal = ring.normal;
    if (ring.is_tip() && std::abs(normal.y()) >= std::cos(in_.crease)) {
      ring.flat = true;
      normal = Point(0, std::copysign(1, normal.y()));
    }
    const int count = ring.flat ? 1 : ring.is_tip() ? segments_ : segments_ + 1;
    for (int i = 0; i < count; ++i) {
      const double share = ring.flat ? 0.5 : (i + (ring.is_tip() ? 0.5 : 0)) / segments_;
      const double turn = share == 1 && in_.angle == 2 * std::numbers::pi ? 0 : share * in_.angle;
      const double c = std::cos(turn);
      const double s = std::sin(turn);
      surface_.vertices.emplace_back(ring.place.x() * c, ring.place.x() * s, ring.place.y());
      surface_.normals.emplace_back(normal.x() * c, normal.x() * s, normal.y());
      surface_.texcoords.emplace_back(share * in_.angle / (2 * std::numbers::pi) * around_,
                                      ring.along);
    }
  }

  void AddBand(int from, int to) {
    const Ring& a = rings_[static_cast<std::size_t>(from)];
    const Ring& b = rings_[static_cast<std::size_t>(to)];
    for (int i = 0; i < segments_; ++i) {
      const int at_a = a.first + (a.flat ? 0 : i);
      const int at_b = b.first + (b.flat ? 0 : i);
      if (!a.is_tip()) surface_.triangles.push_back({at_a, at_a + 1, b.is_tip() ? at_b : at_b + 1});
      if (!b.is_tip()) surface_.triangles.push_back({at_a, at_b + 1, at_b});
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
        surface_.texcoords.emplace_back(p);
      }
      for (std::array<int, 3> triangle : in_.partition.triangles) {
        if (turn != 0) std::swap(triangle[1], triangle[2]);
        for (int& corner : triangle) corner += first;
        surface_.triangles.push_back(triangle);
      }
    }
  }

  const TurnedLook& in_;
  std::vector<double> along_;  // texture coordinates of the line's points
  double around_ = 1;          // the one at the end of a whole turn
  int segments_ = 0;
  Surface surface_;
  std::vector<Ring> rings_;
  std::vector<std::pair<int, int>> starts_;  // rings of each edge that is seen
  std::size_t last_corner_ = 0;              // where the last of them ends
};

}  // namespace

Surface Make(const TurnedLook& look) {
  Surface surface = Looker(look).Run();
  if (look.texture.unit == Texture::Unit::kNone) surface.texcoords.clear();
  RoundForText(surface);
  return surface;
}

}  // namespace mjforge::solid
