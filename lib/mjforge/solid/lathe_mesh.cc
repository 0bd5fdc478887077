// Render mesh of a lathe: rings of vertices, bands of triangles between rings, and the end faces of
// a revolution by less than a whole turn.

#include <algorithm>
#include <cmath>
#include <functional>

#include "mjforge/solid/render_mesh.h"

namespace mjforge::solid {
namespace {

constexpr double kLevelNormal = 1e-9;  // normals with a smaller radial component are vertical

/// A circle of vertices about the axis.
struct Ring {
  Point2 place;                 // r, z
  Point2 normal;                // r, z
  double along = 0;             // texture coordinate along the profile
  bool from_above = false;      // belongs to a level disc whose texture is projected from above
  int first = 0;                // index of its first vertex
  bool has_one_vertex = false;  // a point of the axis with a single vertex
  bool is_tip() const { return place.x() == 0; }
};

/// Band of faces that a visible edge of the outline sweeps, between two rings.
struct Band {
  int from = 0;
  int to = 0;
  int covers = 0;  // number of surfaces around the band: see CoversOf()
};

Point2 OutwardOf(const Point2& from, const Point2& to) {
  const Point2 side = to - from;
  return Point2(side.y(), -side.x()).normalized();
}

/// Returns the arc length of each point along the line, m, followed by the total length.
std::vector<double> Lengths(const std::vector<Point2>& line, bool closed) {
  std::vector<double> lengths = {0};
  const std::size_t count = line.size();
  for (std::size_t i = 1; i < count + (closed ? 1 : 0); ++i)
    lengths.push_back(lengths.back() + (line[i % count] - line[i - 1]).norm());
  if (!closed) lengths.push_back(lengths.back());
  return lengths;
}

/// Converts arc lengths to texture coordinates along the profile. Returns the texture coordinate
/// of a whole turn.
double MapTexture(const TextureMapping& texture, const std::vector<Point2>& line,
                  std::vector<double>& along) {
  // Texture coordinates begin at the line's end, because rows of a picture are counted from the
  // top.
  const double length = along.back();
  double radius = 0;
  for (const Point2& p : line) radius = std::max(radius, p.x());
  const bool by_metre = texture.unit == TextureMapping::Unit::kMetre;
  const double scale = texture.repeat.y() / (by_metre ? 1 : length);
  for (double& number : along) number = (length - number) * scale;
  return texture.repeat.x() * (by_metre ? kWholeTurn * radius : 1);
}

class LatheMesher {
 public:
  LatheMesher(const Lathe& lathe, const Outline& outline) : lathe_(lathe), outline_(outline) {
    if (lathe.texture.unit != TextureMapping::Unit::kNone) {
      along_ = Lengths(lathe.profile, !lathe.wall);
      around_ = MapTexture(lathe.texture, lathe.profile, along_);
    }
    const Eigen::AlignedBox2d box = BoxAround(outline.corners);
    const double half_size = std::max(box.max().x(), box.sizes().y() / 2);
    const double angle = lathe.angle;
    const double per_turn = SegmentsPerTurn(box.max().x(), ChordError(half_size), angle);
    segments_ = std::max(3, static_cast<int>(std::ceil(per_turn * angle / kWholeTurn - 1e-9)));
    closes_ = angle == kWholeTurn && along_.empty();
    for (int i = 0; i <= 2 * segments_; ++i) {
      const double turn = i == 2 * segments_ && angle == kWholeTurn ? 0 : TurnOf(0.5 * i);
      directions_.emplace_back(std::cos(turn), std::sin(turn));
    }
  }

  TriangleMesh Run(const ConvexPartition& partition) {
    const std::size_t count = outline_.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!IsVisible(i)) continue;
      const int from = !bands_.empty() && last_corner_ == i ? JoinedTo(i) : AddRing(i, i);
      const int to = AddRing(outline_.Next(i), i);
      bands_.push_back({from, to, CoversOf(i)});
      last_corner_ = outline_.Next(i);
    }
    CloseOutline();
    Reserve();
    for (Ring& ring : rings_) AddVertices(ring);
    // Viewers draw translucent meshes in the order of their faces, so the innermost bands come
    // first.
    std::ranges::stable_sort(bands_, std::greater(), [&](const Band& band) { return band.covers; });
    for (const Band& band : bands_) AddBand(band.from, band.to);
    if (lathe_.angle != kWholeTurn) AddCutFaces(partition);
    return std::move(mesh_);
  }

 private:
  const Point2& At(std::size_t i) const { return outline_.corners[i]; }

  double TurnOf(double segments) const { return segments / segments_ * lathe_.angle; }

  /// Returns true unless the edge is on the axis.
  bool IsVisible(std::size_t edge) const {
    return At(edge).x() != 0 || At(outline_.Next(edge)).x() != 0;
  }

  Point2 NormalOf(std::size_t edge) const { return OutwardOf(At(edge), At(outline_.Next(edge))); }

  /// Returns the texture coordinate of a corner, which differs between its two edges at the seam of
  /// a closed profile.
  double Along(std::size_t corner, std::size_t edge) const {
    if (along_.empty()) return 0;
    const std::vector<std::size_t>& sources = outline_.sources;
    const std::size_t a = sources[edge];
    const std::size_t b = sources[outline_.Next(edge)];
    const bool closes = std::max(a, b) - std::min(a, b) > 1;  // from the last point to the first
    return closes && sources[corner] == 0 ? along_.back() : along_[sources[corner]];
  }

  /// Returns the number of surfaces that a ray crosses which begins on the outer side of an edge,
  /// at its middle, and points away from the axis: 2 for the inside of a cup, 0 for its outside.
  int CoversOf(std::size_t edge) const {
    constexpr double kBeside = 1e-9;  // m
    const Point2 place = (At(edge) + At(outline_.Next(edge))) / 2 + kBeside * NormalOf(edge);
    int covers = 0;
    for (std::size_t i = 0; i < outline_.corners.size(); ++i) {
      const Point2& a = At(i);
      const Point2& b = At(outline_.Next(i));
      if ((a.y() > place.y()) == (b.y() > place.y())) continue;
      const double share = (place.y() - a.y()) / (b.y() - a.y());
      if (a.x() + share * (b.x() - a.x()) > place.x()) ++covers;
    }
    return covers;
  }

  int AddRing(std::size_t corner, std::size_t edge) { return Add(RingOf(corner, edge)); }

  Ring RingOf(std::size_t corner, std::size_t edge) const {
    const Point2 normal = NormalOf(edge);
    const bool is_level = std::abs(normal.x()) < kLevelNormal;
    return {At(corner), normal, Along(corner, edge),
            is_level && lathe_.texture.unit == TextureMapping::Unit::kMetre};
  }

  int Add(const Ring& ring) {
    rings_.push_back(ring);
    return static_cast<int>(rings_.size()) - 1;
  }

  /// Averages the normals of two rings at one corner if its crease is smooth. Returns true if the
  /// rings can then share their vertices.
  bool Smooth(Ring& a, Ring& b) const {
    if (a.normal.dot(b.normal) < std::cos(lathe_.crease) || a.is_tip()) return false;
    a.normal = b.normal = (a.normal + b.normal).normalized();
    return a.along == b.along && a.from_above == b.from_above;
  }

  /// Returns the ring at the end of the previous edge if this edge can share it, or a new ring.
  int JoinedTo(std::size_t edge) {
    const int before = bands_.back().to;
    Ring next = RingOf(edge, edge);
    return Smooth(rings_[static_cast<std::size_t>(before)], next) ? before : Add(next);
  }

  /// Joins the last edge to the first if the crease between them is smooth.
  void CloseOutline() {
    if (last_corner_ != 0 || !IsVisible(0)) return;
    const int first = bands_.front().from;
    const auto last = static_cast<std::size_t>(bands_.back().to);
    if (!Smooth(rings_[static_cast<std::size_t>(first)], rings_[last])) return;
    bands_.back().to = first;
    rings_.pop_back();
  }

  /// Reserves memory for all vertices and faces, except those of the cut faces.
  void Reserve() {
    const auto segments = static_cast<std::size_t>(segments_);
    const std::size_t vertices = (segments + 1) * rings_.size();
    mesh_.vertices.reserve(vertices);
    mesh_.normals.reserve(vertices);
    if (!along_.empty()) mesh_.texcoords.reserve(vertices);
    mesh_.triangles.reserve(2 * segments * bands_.size());
  }

  void AddVertices(Ring& ring) {
    ring.first = static_cast<int>(mesh_.vertices.size());
    Point2 normal = ring.normal;
    if (ring.is_tip() && std::abs(normal.y()) >= std::cos(lathe_.crease)) {
      ring.has_one_vertex = along_.empty() || ring.from_above;
      normal = Point2(0, std::copysign(1, normal.y()));
    }
    const int count = ring.has_one_vertex        ? 1
                      : ring.is_tip() || closes_ ? segments_
                                                 : segments_ + 1;
    for (int i = 0; i < count; ++i) {
      const int halves = ring.has_one_vertex ? 0 : 2 * i + (ring.is_tip() ? 1 : 0);
      const Point2& direction = directions_[static_cast<std::size_t>(halves)];
      const double r = ring.place.x();
      mesh_.vertices.emplace_back(r * direction.x(), r * direction.y(), ring.place.y());
      mesh_.normals.emplace_back(normal.x() * direction.x(), normal.x() * direction.y(),
                                 normal.y());
      if (!along_.empty()) mesh_.texcoords.push_back(TexcoordOf(ring, halves));
    }
  }

  Point2 TexcoordOf(const Ring& ring, int halves) const {
    if (!ring.from_above) return {TurnOf(0.5 * halves) / kWholeTurn * around_, ring.along};
    const Point2& direction = directions_[static_cast<std::size_t>(halves)];
    return (ring.place.x() * Point2(direction.x(), -direction.y()))
        .cwiseProduct(lathe_.texture.repeat);
  }

  void AddBand(int from, int to) {
    const Ring& a = rings_[static_cast<std::size_t>(from)];
    const Ring& b = rings_[static_cast<std::size_t>(to)];
    for (int i = 0; i < segments_; ++i) {
      const int next = closes_ && i + 1 == segments_ ? 0 : i + 1;
      const int at_a = a.first + (a.has_one_vertex ? 0 : i);
      const int at_b = b.first + (b.has_one_vertex ? 0 : i);
      if (a.is_tip())
        mesh_.triangles.push_back({at_a, b.first + next, at_b});
      else if (b.is_tip())
        mesh_.triangles.push_back({at_a, a.first + next, at_b});
      else
        AddQuad(at_a, a.first + next, b.first + next, at_b, mesh_);
    }
  }

  /// Adds the outline as a face at both ends of a revolution by less than a whole turn.
  void AddCutFaces(const ConvexPartition& partition) {
    for (const double turn : {0.0, lathe_.angle}) {
      const int first = static_cast<int>(mesh_.vertices.size());
      const double c = std::cos(turn);
      const double s = std::sin(turn);
      const double sign = turn == 0 ? -1 : 1;
      for (const Point2& p : outline_.corners) {
        mesh_.vertices.emplace_back(p.x() * c, p.x() * s, p.y());
        mesh_.normals.emplace_back(-sign * s, sign * c, 0);
        if (!along_.empty()) mesh_.texcoords.emplace_back(p);
      }
      AddFace(partition.triangles, first, turn != 0, mesh_);
    }
  }

  const Lathe& lathe_;
  const Outline& outline_;
  std::vector<double> along_;  // texture coordinates of the profile's points; empty without texture
  double around_ = 1;          // texture coordinate at the end of a whole turn
  int segments_ = 0;
  bool closes_ = false;             // the last segment ends at the first segment's vertices
  std::vector<Point2> directions_;  // cosine and sine at each half segment
  TriangleMesh mesh_;
  std::vector<Ring> rings_;
  std::vector<Band> bands_;
  std::size_t last_corner_ = 0;  // corner at the end of the last band
};

}  // namespace

TriangleMesh MakeLatheMesh(const Lathe& lathe, const Outline& outline,
                           const ConvexPartition& partition) {
  TriangleMesh mesh = LatheMesher(lathe, outline).Run(partition);
  RoundCoordinates(mesh);
  return mesh;
}

}  // namespace mjforge::solid
