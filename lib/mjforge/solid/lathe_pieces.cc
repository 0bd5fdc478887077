// Convex pieces of a lathe: cylinder geoms, meshes of whole turns, and wedges.

#include "mjforge/solid/lathe_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mjforge::solid {
namespace {

// Least share of its area that a polygon must keep when only its corners that face the axis are
// moved onto the circumscribed polygon of a circle. Otherwise all its corners are moved.
constexpr double kLeastArea = 0.75;
constexpr double kLevel = 1e-9;  // largest slope of a level side

bool IsOnAxis(const Point2& p) { return p.x() == 0; }

/// Returns true if ab is horizontal, up to the rounding errors at the end of a wall on the axis.
bool IsLevel(const Point2& a, const Point2& b) {
  return std::abs(a.y() - b.y()) <= kLevel * std::abs(a.x() - b.x());
}

/// Returns true if this side of a counter-clockwise polygon faces the axis and is not on it.
bool FacesAxis(const Point2& from, const Point2& to) {
  return to.y() < from.y() && !IsLevel(from, to) && !(IsOnAxis(from) && IsOnAxis(to));
}

using Polygon = std::vector<Point2>;

class LathePieceMaker {
 public:
  LathePieceMaker(const Lathe& lathe, const Outline& outline, const ConvexPartition& partition)
      : outline_(outline), partition_(partition) {
    constexpr double kWhole = 2 * std::numbers::pi;
    is_whole_ = lathe.angle == kWhole;
    const double share = lathe.facets * lathe.angle / kWhole;
    count_ = is_whole_ ? lathe.facets : std::max(1, static_cast<int>(std::ceil(share - 1e-9)));
    step_ = lathe.angle / count_;
    around_ = 1 / std::cos(step_ / 2);
  }

  std::vector<ConvexPiece> Run() {
    std::vector<ConvexPiece> pieces;
    std::vector<Polygon> polygons = Widened();
    for (Polygon& polygon : polygons) {
      RemoveStraightCorners(polygon);
      const bool is_one = is_whole_ && IsOnePiece(polygon);
      const std::optional<ConvexPiece> cylinder = is_one ? Cylinder(polygon) : std::nullopt;
      pieces.push_back(cylinder ? *cylinder : is_one ? Whole(polygon) : Wedge(polygon));
    }
    return pieces;
  }

 private:
  /// Returns the polygons of the partition after moving corners outwards.
  std::vector<Polygon> Widened() const {
    std::vector<double> factors(outline_.corners.size(), 1);
    for (std::size_t i = 0; i < factors.size(); ++i) {
      const std::size_t next = outline_.Next(i);
      if (FacesAxis(outline_.corners[i], outline_.corners[next]))
        factors[i] = factors[next] = around_;
    }
    for (;;) {
      std::vector<Polygon> polygons = With(factors);
      if (!Widen(polygons, factors)) return polygons;
    }
  }

  std::vector<Polygon> With(const std::vector<double>& factors) const {
    std::vector<Polygon> polygons;
    for (const std::vector<int>& corners : partition_.convex) {
      Polygon& polygon = polygons.emplace_back();
      for (const int corner : corners) {
        const auto i = static_cast<std::size_t>(corner);
        const Point2& p = outline_.corners[i];
        polygon.emplace_back(p.x() * factors[i], p.y());
      }
    }
    return polygons;
  }

  /// Finds polygons that became too thin, and moves all their corners onto the circumscribed
  /// polygon. Returns false if nothing changed.
  bool Widen(const std::vector<Polygon>& polygons, std::vector<double>& factors) const {
    bool changed = false;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      const Polygon before = PointsAt(outline_.corners, partition_.convex[i]);
      if (IsConvex(polygons[i]) && AreaOf(polygons[i]) >= kLeastArea * AreaOf(before)) continue;
      for (const int corner : partition_.convex[i]) {
        double& factor = factors[static_cast<std::size_t>(corner)];
        changed |= factor != around_;
        factor = around_;
      }
    }
    return changed;
  }

  static bool IsOnePiece(const Polygon& polygon) {
    bool touches = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point2& from = polygon[i];
      const Point2& to = polygon[(i + 1) % polygon.size()];
      if (FacesAxis(from, to)) return false;
      touches |= IsOnAxis(from) && IsOnAxis(to);
    }
    return touches;
  }

  /// Returns a cylinder geom for a rectangle on the axis, otherwise nullopt.
  static std::optional<ConvexPiece> Cylinder(const Polygon& polygon) {
    const Eigen::AlignedBox2d box = BoxAround(polygon);
    const auto is_corner = [&](const Point2& p) {
      return (p.x() == 0 || p.x() == box.max().x()) &&
             (p.y() == box.min().y() || p.y() == box.max().y());
    };
    if (polygon.size() != 4 || !std::ranges::all_of(polygon, is_corner)) return std::nullopt;
    return ConvexPiece{.type = ConvexPiece::Type::kCylinder,
                       .size = {box.max().x(), box.sizes().y() / 2, 0},
                       .p = {0, 0, box.center().y()}};
  }

  static Eigen::Vector3d At(const Point2& p, double turn) {
    return {p.x() * std::cos(turn), p.x() * std::sin(turn), p.y()};
  }

  /// Returns the piece between the angles 0 and `step_` about the axis, repeated for each facet.
  ConvexPiece Wedge(const Polygon& polygon) const {
    ConvexPiece piece;
    piece.turns.clear();
    for (int i = 0; i < count_; ++i) piece.turns.push_back(i * step_);
    TriangleMesh& mesh = piece.mesh;
    std::vector<int> low;
    std::vector<int> high;
    for (const Point2& p : polygon) {
      low.push_back(static_cast<int>(mesh.vertices.size()));
      mesh.vertices.push_back(At(p, 0));
      high.push_back(low.back());
      if (IsOnAxis(p)) continue;
      ++high.back();
      mesh.vertices.push_back(At(p, step_));
    }
    const std::size_t count = polygon.size();
    for (std::size_t i = 1; i + 1 < count; ++i) {
      AddTriangle(low[0], low[i], low[i + 1], mesh);
      AddTriangle(high[0], high[i + 1], high[i], mesh);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      AddTriangle(low[i], high[i], high[next], mesh);
      AddTriangle(low[i], high[next], low[next], mesh);
    }
    return piece;
  }

  /// Returns a single piece with a ring of vertices for each corner. A corner on the axis becomes a
  /// tip, or is omitted in the middle of a flat end.
  ConvexPiece Whole(const Polygon& polygon) const {
    ConvexPiece piece;
    TriangleMesh& mesh = piece.mesh;
    const std::size_t count = polygon.size();
    std::size_t top = 0;  // the upper of the two corners on the axis
    while (!IsOnAxis(polygon[top]) || !IsOnAxis(polygon[(top + 1) % count])) ++top;
    std::vector<Point2> chain;  // from the lower to the upper corner on the axis
    for (std::size_t i = 1; i <= count; ++i) chain.push_back(polygon[(top + i) % count]);
    if (IsLevel(chain[0], chain[1])) chain.erase(chain.begin());
    if (IsLevel(chain[chain.size() - 2], chain.back())) chain.pop_back();
    std::vector<int> starts;
    for (const Point2& p : chain) {
      starts.push_back(static_cast<int>(mesh.vertices.size()));
      for (int i = 0; i < (IsOnAxis(p) ? 1 : count_); ++i)
        mesh.vertices.push_back(At(p, i * step_));
    }
    const auto at = [&](std::size_t ring, int i) {
      return starts[ring] + (IsOnAxis(chain[ring]) ? 0 : i % count_);
    };
    for (std::size_t ring = 0; ring + 1 < chain.size(); ++ring) {
      for (int i = 0; i < count_; ++i) {
        AddTriangle(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), mesh);
        AddTriangle(at(ring, i), at(ring + 1, i + 1), at(ring + 1, i), mesh);
      }
    }
    const std::size_t last = chain.size() - 1;
    for (int i = 1; i + 1 < count_; ++i) {
      AddTriangle(at(0, 0), at(0, i + 1), at(0, i), mesh);
      AddTriangle(at(last, 0), at(last, i), at(last, i + 1), mesh);
    }
    return piece;
  }

  static void AddTriangle(int a, int b, int c, TriangleMesh& mesh) {
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  }

  const Outline& outline_;
  const ConvexPartition& partition_;
  bool is_whole_ = true;
  int count_ = 0;
  double step_ = 0;    // angle of a facet, rad
  double around_ = 1;  // circumradius of the facets, relative to the circle
};

}  // namespace

std::vector<ConvexPiece> MakeLathePieces(const Lathe& lathe, const Outline& outline,
                                         const ConvexPartition& partition) {
  return LathePieceMaker(lathe, outline, partition).Run();
}

}  // namespace mjforge::solid
