#include "mjforge/solid/wedges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mjforge::solid {
namespace {

// With corners on the true circle outside and around it inside, a wall keeps so much of its area.
constexpr double kLeastArea = 0.75;
constexpr double kLevel = 1e-9;

bool IsOnAxis(const Point& p) { return p.x() == 0; }

/// Up to rounding, as where a wall ends on the axis.
bool IsLevel(const Point& a, const Point& b) {
  return std::abs(a.y() - b.y()) <= kLevel * std::abs(a.x() - b.x());
}

/// Whether the side of a counter-clockwise polygon faces the axis, at a distance from it.
bool FacesAxis(const Point& from, const Point& to) {
  return to.y() < from.y() && !IsLevel(from, to) && !(IsOnAxis(from) && IsOnAxis(to));
}

using Polygon = std::vector<Point>;

class Turner {
 public:
  Turner(const Outline& outline, const Partition& partition, double angle, int facets)
      : outline_(outline), partition_(partition) {
    constexpr double kWhole = 2 * std::numbers::pi;
    is_whole_ = angle == kWhole;
    count_ = is_whole_ ? facets
                       : std::max(1, static_cast<int>(std::ceil(facets * angle / kWhole - 1e-9)));
    step_ = angle / count_;
    around_ = 1 / std::cos(step_ / 2);
  }

  std::vector<Piece> Run() {
    std::vector<Piece> pieces;
    std::vector<Polygon> polygons = Widened();
    for (Polygon& polygon : polygons) {
      RemoveStraightCorners(polygon);
      const bool is_one = is_whole_ && IsOnePiece(polygon);
      const std::optional<Piece> cylinder = is_one ? Cylinder(polygon) : std::nullopt;
      pieces.push_back(cylinder ? *cylinder : is_one ? Whole(polygon) : Wedge(polygon));
    }
    return pieces;
  }

 private:
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
        const Point& p = outline_.corners[i];
        polygon.emplace_back(p.x() * factors[i], p.y());
      }
    }
    return polygons;
  }

  /// Puts all corners of polygons that became too thin around the true circles. False: of none.
  bool Widen(const std::vector<Polygon>& polygons, std::vector<double>& factors) const {
    bool changed = false;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      Polygon before;
      for (const int corner : partition_.convex[i])
        before.push_back(outline_.corners[static_cast<std::size_t>(corner)]);
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
      const Point& from = polygon[i];
      const Point& to = polygon[(i + 1) % polygon.size()];
      if (FacesAxis(from, to)) return false;
      touches |= IsOnAxis(from) && IsOnAxis(to);
    }
    return touches;
  }

  /// MuJoCo's own cylinder, for a rectangle on the axis; nothing for any other.
  static std::optional<Piece> Cylinder(const Polygon& polygon) {
    Eigen::AlignedBox2d box;
    for (const Point& p : polygon) box.extend(p);
    const auto is_corner = [&](const Point& p) {
      return (p.x() == 0 || p.x() == box.max().x()) &&
             (p.y() == box.min().y() || p.y() == box.max().y());
    };
    if (polygon.size() != 4 || !std::ranges::all_of(polygon, is_corner)) return std::nullopt;
    Piece piece;
    piece.type = Piece::Type::kCylinder;
    piece.size = {box.max().x(), box.sizes().y() / 2, 0};
    piece.p.z() = box.center().y();
    return piece;
  }

  static Eigen::Vector3d At(const Point& p, double turn) {
    return {p.x() * std::cos(turn), p.x() * std::sin(turn), p.y()};
  }

  /// Between the angles 0 and step_.
  Piece Wedge(const Polygon& polygon) const {
    Piece piece;
    piece.turns.clear();
    for (int i = 0; i < count_; ++i) piece.turns.push_back(i * step_);
    std::vector<int> low;
    std::vector<int> high;
    for (const Point& p : polygon) {
      low.push_back(static_cast<int>(piece.vertices.size()));
      piece.vertices.push_back(At(p, 0));
      high.push_back(low.back());
      if (IsOnAxis(p)) continue;
      ++high.back();
      piece.vertices.push_back(At(p, step_));
    }
    const std::size_t count = polygon.size();
    for (std::size_t i = 1; i + 1 < count; ++i) {
      AddTriangle(piece, low[0], low[i], low[i + 1]);
      AddTriangle(piece, high[0], high[i + 1], high[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      AddTriangle(piece, low[i], high[i], high[next]);
      AddTriangle(piece, low[i], high[next], low[next]);
    }
    return piece;
  }

  /// A ring of corners for each corner that is not on the axis; those on it are tips, or in the
  /// middle of a flat end, which needs none.
  Piece Whole(const Polygon& polygon) const {
    Piece piece;
    piece.turns = {0};
    const std::size_t count = polygon.size();
    std::size_t top = 0;  // the corner at the axis' upper end
    while (!IsOnAxis(polygon[top]) || !IsOnAxis(polygon[(top + 1) % count])) ++top;
    std::vector<Point> chain;  // from the lower end outwards and up
    for (std::size_t i = 1; i <= count; ++i) chain.push_back(polygon[(top + i) % count]);
    if (IsLevel(chain[0], chain[1])) chain.erase(chain.begin());
    if (IsLevel(chain[chain.size() - 2], chain.back())) chain.pop_back();
    std::vector<int> starts;
    for (const Point& p : chain) {
      starts.push_back(static_cast<int>(piece.vertices.size()));
      for (int i = 0; i < (IsOnAxis(p) ? 1 : count_); ++i)
        piece.vertices.push_back(At(p, i * step_));
    }
    const auto at = [&](std::size_t ring, int i) {
      return starts[ring] + (IsOnAxis(chain[ring]) ? 0 : i % count_);
    };
    for (std::size_t ring = 0; ring + 1 < chain.size(); ++ring) {
      for (int i = 0; i < count_; ++i) {
        AddTriangle(piece, at(ring, i), at(ring, i + 1), at(ring + 1, i + 1));
        AddTriangle(piece, at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
      }
    }
    const std::size_t last = chain.size() - 1;
    for (int i = 1; i + 1 < count_; ++i) {
      AddTriangle(piece, at(0, 0), at(0, i + 1), at(0, i));
      AddTriangle(piece, at(last, 0), at(last, i), at(last, i + 1));
    }
    return piece;
  }

  static void AddTriangle(Piece& piece, int a, int b, int c) {
    if (a != b && b != c && c != a) piece.triangles.push_back({a, b, c});
  }

  const Outline& outline_;
  const Partition& partition_;
  bool is_whole_ = true;
  int count_ = 0;
  double step_ = 0;    // rad, of a facet
  double around_ = 1;  // from a circle to the corners of facets around it
};

}  // namespace

std::vector<Piece> TurnedPieces(const Outline& outline, const Partition& partition, double angle,
                                int facets) {
  return Turner(outline, partition, angle, facets).Run();
}

}  // namespace mjforge::solid
