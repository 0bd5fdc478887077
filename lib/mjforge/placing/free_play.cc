// Minkowski erosion of regions by footprints, and areas of footprints outside of regions.

#include "mjforge/placing/free_play.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "mjforge/placing/enclosing_disc.h"
#include "mjforge/solid/solid.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;

constexpr double kFitTolerance = 1e-9;  // m, so that a footprint as large as its region fits
constexpr int kTangents = 64;           // sides of the polygon that replaces a disc, for areas
constexpr int kBisections = 50;
constexpr double kBalance = 1e-3;     // m; a body whose centre of mass is nearer to an edge may tip
constexpr double kLeastArea = 1e-12;  // m^2; smaller footprints are points or lines

// Half plane of the points p with normal . p <= limit; the normal has length 1.
struct HalfPlane {
  Vector2d normal;
  double limit;
};

bool IsDisc(const model::Region& region) { return region.type == model::RegionType::kDisc; }

// Returns the half planes whose intersection is the region, shrunk by its margin; for a disc, half
// planes at kTangents tangents.
std::vector<HalfPlane> BordersOf(const model::Region& region) {
  std::vector<HalfPlane> borders;
  const Vector2d half = region.half_size.array() - region.margin;
  if (region.type == model::RegionType::kBox) {
    borders = {{{1, 0}, half.x()}, {{-1, 0}, half.x()}, {{0, 1}, half.y()}, {{0, -1}, half.y()}};
  } else if (region.type == model::RegionType::kDisc) {
    for (int i = 0; i < kTangents; ++i) {
      const double angle = 2 * std::numbers::pi * i / kTangents;
      borders.push_back({{std::cos(angle), std::sin(angle)}, half.x()});
    }
  } else {
    for (std::size_t i = 0; i < region.corners.size(); ++i) {
      const Vector2d normal = solid::OutwardNormal(region.corners, i);
      borders.push_back({normal, normal.dot(region.corners[i]) - region.margin});
    }
  }
  return borders;
}

// Returns the share of the footprint's area that is outside of the borders after a translation.
double ShareOutside(const std::vector<HalfPlane>& borders, const Polygon& outline,
                    const Vector2d& translation) {
  Polygon inside = outline;
  for (const HalfPlane& border : borders)
    inside = solid::Clipped(inside, border.normal, border.limit - border.normal.dot(translation));
  return 1 - solid::AreaOf(inside) / solid::AreaOf(outline);
}

double Between(double low, double high, double u) { return low + (high - low) * (u + 1) / 2; }

// Maps numbers (u, v), each from -1 to 1, to a point of a convex polygon: u to the extent of the
// polygon along x, v to the extent along y at this x.
Vector2d PointIn(const Polygon& polygon, const Vector2d& uv) {
  const Eigen::AlignedBox2d box = solid::BoxAround(polygon);
  // Rounding must not move the last position beyond the corners.
  const double x =
      std::clamp(Between(box.min().x(), box.max().x(), uv.x()), box.min().x(), box.max().x());
  // The corners of an edge along y may differ along x by a rounding error.
  constexpr double kRounding = 1e-9;  // m
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Vector2d a = polygon[i];
    Vector2d b = polygon[(i + 1) % polygon.size()];
    if (a.x() > b.x()) std::swap(a, b);
    if (x < a.x() - kRounding || x > b.x() + kRounding) continue;
    const bool is_along_y = b.x() - a.x() <= kRounding;
    const double share = is_along_y ? 0 : std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0);
    const double y = a.y() + share * (b.y() - a.y());
    low = std::min({low, y, is_along_y ? b.y() : y});
    high = std::max({high, y, is_along_y ? b.y() : y});
  }
  return {x, Between(low, high, uv.y())};
}

std::optional<Vector2d> PositionInPolygon(const model::Region& region, const Footprint& footprint,
                                          const Vector2d& uv) {
  const std::vector<HalfPlane> borders = BordersOf(region);
  // Begins with a square that contains all translations that keep the footprint in the region.
  const Eigen::AlignedBox2d& box = footprint.Box();
  const double reach = 4 * (region.half_size.norm() + box.center().norm() + box.diagonal().norm());
  const Vector2d middle = model::MiddleOf(region);
  Polygon play = {middle + reach * Vector2d(-1, -1), middle + reach * Vector2d(1, -1),
                  middle + reach * Vector2d(1, 1), middle + reach * Vector2d(-1, 1)};
  for (const HalfPlane& border : borders) {
    const double limit = border.limit - footprint.Support(border.normal);
    play = solid::Clipped(play, border.normal, limit + kFitTolerance);
  }
  if (play.empty()) return std::nullopt;
  return PointIn(play, uv);
}

// Returns a translation t that keeps the footprint within a disc of radius R. These translations
// are an intersection of discs, |t + c_i| <= R - r_i; a ray from the middle leaves each disc once.
std::optional<Vector2d> PositionInDisc(const model::Region& region, const Footprint& footprint,
                                       const Vector2d& uv) {
  const double radius = region.half_size.x() - region.margin;
  const Disc around = EnclosingDisc(footprint.discs());
  if (around.radius > radius + kFitTolerance) return std::nullopt;
  const double share = uv.norm();
  if (!(share > 0)) return -around.center;
  const Vector2d way = uv / share;
  double farthest = std::numeric_limits<double>::infinity();
  for (const Disc& disc : footprint.discs()) {
    const Vector2d from = disc.center - around.center;
    const double along = from.dot(way);
    const double rest = radius - disc.radius;
    const double root = along * along - from.squaredNorm() + rest * rest;
    farthest = std::min(farthest, std::sqrt(std::max(root, 0.0)) - along);
  }
  return -around.center + std::min(share, 1.0) * std::max(farthest, 0.0) * way;
}

// Returns true if the centre of mass is inside of the borders after a translation, at least
// kBalance away from them.
bool HasCenter(const std::vector<HalfPlane>& borders, const Overhang& overhang,
               const Vector2d& translation) {
  return std::ranges::all_of(borders, [&](const HalfPlane& border) {
    return border.normal.dot(overhang.p_Cm + translation) <= border.limit - kBalance;
  });
}

// Returns true if an overhang allows a translation of a footprint, with the tolerance `spare` for
// the share.
bool IsAllowed(const std::vector<HalfPlane>& borders, const Polygon& outline,
               const Vector2d& translation, const Overhang& overhang, double spare) {
  return HasCenter(borders, overhang, translation) &&
         ShareOutside(borders, outline, translation) <= overhang.share + spare;
}

// Returns the translation of the footprint's middle to the middle of the region. If the centre of
// mass is then outside, moves it inside on the way to the middle of the region.
Vector2d BalancedMiddle(const model::Region& region, const std::vector<HalfPlane>& borders,
                        const Footprint& footprint, const Overhang& overhang) {
  Vector2d middle = model::MiddleOf(region) - footprint.Box().center();
  if (HasCenter(borders, overhang, middle)) return middle;
  const Vector2d way = model::MiddleOf(region) - overhang.p_Cm - middle;
  double low = 0;
  double high = 1;
  for (int i = 0; i < kBisections; ++i) {
    const double at = (low + high) / 2;
    (HasCenter(borders, overhang, middle + at * way) ? high : low) = at;
  }
  return middle + high * way;
}

// Finds, by bisection, the largest distance by which the footprint can be moved from the middle.
// The share of its area outside does not decrease with the distance, because the area of the
// intersection of convex sets is a log-concave function of the translation (Brunn-Minkowski).
std::optional<Vector2d> PositionWithOverhang(const model::Region& region,
                                             const Footprint& footprint, const Polygon& outline,
                                             const Vector2d& uv, const Overhang& overhang) {
  const std::vector<HalfPlane> borders = BordersOf(region);
  const auto is_allowed = [&](const Vector2d& translation) {
    return IsAllowed(borders, outline, translation, overhang, 0);
  };
  const Vector2d middle = BalancedMiddle(region, borders, footprint, overhang);
  if (!is_allowed(middle)) return std::nullopt;
  const double share = std::min(1.0, IsDisc(region) ? uv.norm() : uv.cwiseAbs().maxCoeff());
  if (!(share > 0)) return middle;
  const Vector2d way = uv.cwiseProduct(region.half_size).normalized();
  double low = 0;
  double high = 2 * region.half_size.norm() + footprint.Box().diagonal().norm();
  for (int i = 0; i < kBisections; ++i) {
    const double at = (low + high) / 2;
    (is_allowed(middle + at * way) ? low : high) = at;
  }
  return middle + share * low * way;
}

}  // namespace

std::optional<Vector2d> PositionIn(const model::Region& region, const Footprint& footprint,
                                   const Vector2d& uv, const Overhang& overhang) {
  if (overhang.share > 0) {
    const Polygon outline = footprint.Outline();
    if (solid::AreaOf(outline) > kLeastArea)
      return PositionWithOverhang(region, footprint, outline, uv, overhang);
  }
  return IsDisc(region) ? PositionInDisc(region, footprint, uv)
                        : PositionInPolygon(region, footprint, uv);
}

bool FitsAt(const model::Region& region, const Footprint& footprint, const Vector2d& translation,
            const Overhang& overhang) {
  if (IsDisc(region)) {
    const double radius = region.half_size.x() - region.margin + 2 * kFitTolerance;
    const auto is_inside = [&](const Disc& disc) {
      return (disc.center + translation).norm() + disc.radius <= radius;
    };
    if (std::ranges::all_of(footprint.discs(), is_inside)) return true;
  } else {
    const auto is_inside = [&](const HalfPlane& border) {
      return border.normal.dot(translation) + footprint.Support(border.normal) <=
             border.limit + 2 * kFitTolerance;  // twice the tolerance of PositionIn()
    };
    if (std::ranges::all_of(BordersOf(region), is_inside)) return true;
  }
  if (!(overhang.share > 0)) return false;
  const Polygon outline = footprint.Outline();
  return solid::AreaOf(outline) > kLeastArea &&
         IsAllowed(BordersOf(region), outline, translation, overhang, kFitTolerance);
}

}  // namespace mjforge::placing
