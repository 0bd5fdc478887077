#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/solid/look.h"
#include "mjforge/solid/sweep.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
constexpr int kAlongCurve = 32;  // stations to a curve of four spans

class Sweeper {
 public:
  Sweeper(const std::vector<Span>& spans, const Tube& tube) : tube_(tube) {
    const Texture& texture = tube.texture;
    const bool by_metre = texture.unit == Texture::Unit::kMetre;
    has_texture_ = texture.unit != Texture::Unit::kNone;
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : tube.path) box.extend(p);
    const double radius = *std::ranges::max_element(tube.radii);
    const double error = ChordError(box.sizes().maxCoeff() / 2 + radius);
    sides_ = SegmentsOf(radius, error, kWholeTurn);
    const int per_turn =
        tube.smooth ? kAlongCurve : SegmentsOf(tube.bend + radius, error, kWholeTurn);
    stations_ = StationsOf(spans, tube.closed, per_turn);
    around_ = texture.repeat.x() * (by_metre ? 2 * pi * radius : 1);
    along_ = texture.repeat.y() / (by_metre ? 1 : stations_.back().along);
  }

  Surface Run() {
    AddSide(0);
    if (tube_.wall) AddSide(*tube_.wall);
    if (!tube_.closed) {
      AddEnd(stations_.front(), -1);
      AddEnd(stations_.back(), 1);
    }
    return std::move(surface_);
  }

 private:
  /// A point at the distance r around the line, on the plane that ends it.
  static Vector3d At(const Station& station, double share, double r) {
    const Vector3d across = r * Across(station, share);
    return station.p + across -
           across.dot(station.cut) / station.way.dot(station.cut) * station.way;
  }

  /// Where the texture ends, it begins again.
  int RingSize() const { return has_texture_ ? sides_ + 1 : sides_; }

  static Vector3d Across(const Station& station, double share) {
    const double turn = share == 1 ? 0 : 2 * pi * share;
    return std::cos(turn) * station.x + std::sin(turn) * station.y();
  }

  int Add(const Vector3d& p, const Vector3d& normal, double u, double v) {
    surface_.vertices.push_back(p);
    surface_.normals.push_back(normal);
    if (has_texture_) surface_.texcoords.emplace_back(u, v);
    return static_cast<int>(surface_.vertices.size()) - 1;
  }

  int AddRing(const Station& station, const Vector3d* way_before, double less) {
    const int first = static_cast<int>(surface_.vertices.size());
    const double side = less > 0 ? -1 : 1;
    const double length = stations_.back().along;
    for (int i = 0; i < RingSize(); ++i) {
      const double share = static_cast<double>(i) / sides_;
      Vector3d normal = (Across(station, share) - station.slope * station.way).normalized();
      // Where two lines meet in a corner that is seen as smooth.
      if (way_before != nullptr)
        normal = (normal - normal.dot(station.cut) * station.cut).normalized();
      Add(At(station, share, station.radius - less), side * normal, share * around_,
          (length - station.along) * along_);
    }
    return first;
  }

  bool IsSmooth(const Station& end, const Station& start) const {
    return end.way.dot(start.way) >= std::cos(tube_.crease) &&
           std::abs(end.slope - start.slope) < 0.5;
  }

  void AddSide(double less) {
    const int first = static_cast<int>(surface_.vertices.size());
    const bool closes =
        tube_.closed && !has_texture_ && IsSmooth(stations_.back(), stations_.front());
    int before = -1;
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      const Station& station = stations_[i];
      const bool repeats = i > 0 && stations_[i - 1].along == station.along;
      if (repeats && IsSmooth(stations_[i - 1], station)) continue;
      const bool has_next = i + 1 < stations_.size() && stations_[i + 1].along == station.along;
      const bool joins = has_next && IsSmooth(station, stations_[i + 1]);
      const int ring = closes && i + 1 == stations_.size()
                           ? first
                           : AddRing(station, joins ? &station.way : nullptr, less);
      if (before >= 0 && !repeats) AddBand(before, ring, less > 0);
      before = ring;
    }
  }

  void AddBand(int from, int to, bool inward) {
    for (int i = 0; i < sides_; ++i) {
      const int next = (i + 1) % RingSize();
      if (inward)
        AddQuad(from + i, to + i, to + next, from + next, surface_);
      else
        AddQuad(from + i, from + next, to + next, to + i, surface_);
    }
  }

  void AddTriangle(int a, int b, int c, bool is_reversed) {
    if (is_reversed) std::swap(b, c);
    surface_.triangles.push_back({a, b, c});
  }

  /// The disc or ring at an end. `side`: 1 where the line goes out.
  void AddEnd(const Station& station, double side) {
    const Vector3d normal = side * station.way;
    const auto add = [&](double r) {
      const int first = static_cast<int>(surface_.vertices.size());
      for (int i = 0; i < sides_; ++i) {
        const double share = static_cast<double>(i) / sides_;
        const double relative = r / station.radius / 2;
        Add(At(station, share, r), normal, 0.5 + relative * std::cos(2 * pi * share),
            0.5 + relative * std::sin(2 * pi * share));
      }
      return first;
    };
    const int outer = add(station.radius);
    const int inner = tube_.wall ? add(station.radius - *tube_.wall) : -1;
    for (int i = 0; i < sides_; ++i) {
      const int next = (i + 1) % sides_;
      if (inner >= 0) {
        AddTriangle(outer + i, outer + next, inner + next, side < 0);
        AddTriangle(outer + i, inner + next, inner + i, side < 0);
      } else if (i > 0 && next > 0) {
        AddTriangle(outer, outer + i, outer + next, side < 0);
      }
    }
  }

  const Tube& tube_;
  int sides_ = 0;
  std::vector<Station> stations_;
  bool has_texture_ = false;
  double around_ = 1;
  double along_ = 1;
  Surface surface_;
};

Piece Primitive(Piece::Type type, const Vector3d& size, const Vector3d& a, const Vector3d& b) {
  Piece piece;
  piece.type = type;
  piece.size = size;
  piece.p = (a + b) / 2;
  if (a != b) piece.q = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), b - a);
  return piece;
}

/// Between two circles of different radius.
Piece ConeBetween(const Station& a, const Station& b) {
  constexpr int kSides = 12;
  Piece piece;
  for (const Station* station : {&a, &b}) {
    for (int i = 0; i < kSides; ++i) {
      const double turn = 2 * pi * i / kSides;
      piece.vertices.emplace_back(station->p + station->radius *
                                                   (std::cos(turn) * a.x + std::sin(turn) * a.y()));
    }
  }
  for (int i = 0; i < kSides; ++i) {
    const int next = (i + 1) % kSides;
    piece.triangles.push_back({i, next, kSides + next});
    piece.triangles.push_back({i, kSides + next, kSides + i});
    if (i == 0 || next == 0) continue;
    piece.triangles.push_back({0, next, i});
    piece.triangles.push_back({kSides, kSides + i, kSides + next});
  }
  return piece;
}

}  // namespace

Surface SweptLook(const std::vector<Span>& spans, const Tube& tube) {
  return Sweeper(spans, tube).Run();
}

std::vector<Piece> SweptPieces(const std::vector<Span>& spans, const Tube& tube) {
  const std::vector<Station> stations = StationsOf(spans, tube.closed, tube.facets);
  std::vector<std::pair<Station, Station>> steps;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    if (stations[i + 1].along > stations[i].along) steps.emplace_back(stations[i], stations[i + 1]);
  }
  std::vector<Piece> pieces;
  bool was_round = tube.closed;  // whether what ends where a step begins is round there
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& [a, b] = steps[i];
    const bool is_even = std::abs(a.radius - b.radius) <= 1e-9 * a.radius;
    const bool is_end = !tube.closed && (i == 0 || i + 1 == steps.size());
    const bool is_round = is_even && !is_end;
    const double half = (b.p - a.p).norm() / 2;
    // Two flat ends leave a gap where the line turns.
    if (!is_round && !was_round && i > 0)
      pieces.push_back(Primitive(Piece::Type::kSphere, {a.radius, 0, 0}, a.p, a.p));
    if (is_even) {
      pieces.push_back(Primitive(is_end ? Piece::Type::kCylinder : Piece::Type::kCapsule,
                                 {a.radius, half, 0}, a.p, b.p));
    } else {
      pieces.push_back(ConeBetween(a, b));
    }
    was_round = is_round;
  }
  return pieces;
}

}  // namespace mjforge::solid
