// Free play of footprints in regions, against closed forms and membership tests.
#include "mjforge/placing/free_play.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "harness/effort.h"
#include "scene.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;
using model::Region;
using model::RegionType;

Footprint Rectangle(double half_x, double half_y, const Vector2d& center = {0, 0}) {
  std::vector<Disc> corners;
  for (const double x : {-half_x, half_x}) {
    for (const double y : {-half_y, half_y}) corners.push_back({center + Vector2d(x, y), 0});
  }
  return Footprint(corners);
}

Region DiscRegion(double radius) {
  Region region = BoxRegion(radius, radius);
  region.type = RegionType::kDisc;
  return region;
}

Region PolygonRegion(std::vector<Vector2d> corners) {
  Eigen::AlignedBox2d box;
  for (const Vector2d& corner : corners) box.extend(corner);
  Region region = BoxRegion(box.sizes().x() / 2, box.sizes().y() / 2);
  region.type = RegionType::kPolygon;
  region.corners = std::move(corners);
  return region;
}

TEST_CASE("numbers from -1 to 1 reach the outermost positions of a box") {
  Region region = BoxRegion(0.5, 0.3);
  const Footprint footprint = Rectangle(0.1, 0.05, {0.02, 0});
  const auto at = [&](double u, double v) { return *PositionIn(region, footprint, {u, v}, {0}); };
  CHECK((at(1, 1) - Vector2d(0.38, 0.25)).norm() < 1e-8);
  CHECK((at(-1, -1) - Vector2d(-0.42, -0.25)).norm() < 1e-8);
  CHECK((at(0, 0.5) - Vector2d(-0.02, 0.125)).norm() < 1e-8);
  region.margin = 0.05;
  CHECK((at(1, 1) - Vector2d(0.33, 0.2)).norm() < 1e-8);
  region.margin = 0.26;
  CHECK_FALSE(PositionIn(region, footprint, {0, 0}, {0}));
  region.margin = 0.25;
  CHECK(PositionIn(region, footprint, {0, 0}, {0}));
}

TEST_CASE("the middle of a border is reached although its ends are rounded differently") {
  const double radius = GENERATE(0.00995, 0.0123, 0.03, 0.07, 0.1);
  const double half = GENERATE(0.15, 0.2, 0.37);
  const Footprint disc({{{0, 0}, radius}});
  for (const double sign : {-1.0, 1.0}) {
    CHECK((*PositionIn(BoxRegion(half, half), disc, {sign, 0}, {0}) -
           Vector2d(sign * (half - radius), 0))
              .norm() < 1e-8);
    CHECK((*PositionIn(BoxRegion(half, half), disc, {0, sign}, {0}) -
           Vector2d(0, sign * (half - radius)))
              .norm() < 1e-8);
  }
}

TEST_CASE("a footprint as large as its region fits") {
  CHECK(PositionIn(BoxRegion(0.1, 0.2), Rectangle(0.1, 0.2), {1, -1}, {0}));
  CHECK(PositionIn(DiscRegion(0.5), Rectangle(0.3, 0.4), {1, 0}, {0}));
  CHECK_FALSE(PositionIn(DiscRegion(0.4999), Rectangle(0.3, 0.4), {1, 0}, {0}));
  CHECK(PositionIn(DiscRegion(0.5), Footprint({{{0.1, 0}, 0.5}}), {0, 0}, {0}));
  CHECK_FALSE(PositionIn(DiscRegion(0.5), Footprint({{{0.1, 0}, 0.501}}), {0, 0}, {0}));
}

TEST_CASE("with an overhang the centre of mass stays above the region") {
  const Overhang overhang{.share = 1, .p_Cm = {0.05, 0}};
  const Region region = BoxRegion(0.5, 0.3);
  const Footprint footprint = Rectangle(0.1, 0.05);
  CHECK((*PositionIn(region, footprint, {1, 0}, overhang) - Vector2d(0.449, 0)).norm() < 1e-8);
  CHECK((*PositionIn(region, footprint, {-1, 0}, overhang) - Vector2d(-0.549, 0)).norm() < 1e-8);
  CHECK(FitsAt(region, footprint, {0.4489, 0}, overhang));
  CHECK_FALSE(FitsAt(region, footprint, {0.4491, 0}, overhang));
}

TEST_CASE("with an overhang a body whose middle is far from its centre of mass is moved inside") {
  const Overhang overhang{.share = 0.5, .p_Cm = {0, 0.25}};
  const auto at = PositionIn(BoxRegion(0.5, 0.2), Rectangle(0.03, 0.29, {0, 0}), {0, 0}, overhang);
  REQUIRE(at);
  CHECK((*at - Vector2d(0, -0.051)).norm() < 1e-8);
}

TEST_CASE("in a disc the unit disc reaches the outermost positions") {
  const Region region = DiscRegion(0.5);
  const Footprint round({{{0, 0}, 0.1}});
  CHECK((*PositionIn(region, round, {1, 0}, {0}) - Vector2d(0.4, 0)).norm() < 1e-12);
  CHECK((*PositionIn(region, round, {0, -0.5}, {0}) - Vector2d(0, -0.2)).norm() < 1e-12);
  CHECK((*PositionIn(region, round, {3, 4}, {0}) - Vector2d(0.24, 0.32)).norm() < 1e-12);
  // Its far corners touch the circle: (x + 0.1)^2 + 0.3^2 = 0.5^2.
  CHECK((*PositionIn(region, Rectangle(0.1, 0.3), {1, 0}, {0}) - Vector2d(0.3, 0)).norm() < 1e-12);
}

TEST_CASE("in a polygon numbers are shares of its extents") {
  const Region triangle = PolygonRegion({{-1, -1}, {1, -1}, {-1, 1}});
  const Footprint point({Disc()});
  const auto at = [&](double u, double v) { return *PositionIn(triangle, point, {u, v}, {0}); };
  CHECK((at(-1, -1) - Vector2d(-1, -1)).norm() < 1e-7);
  CHECK((at(1, 0) - Vector2d(1, -1)).norm() < 1e-7);
  CHECK((at(-1, 1) - Vector2d(-1, 1)).norm() < 1e-7);
  CHECK((at(0, 1) - Vector2d(0, 0)).norm() < 1e-7);
  // The inscribed circle has the radius 2 - sqrt(2).
  const double radius = 2 - std::sqrt(2);
  CHECK(PositionIn(triangle, Footprint({{{0, 0}, radius}}), {0, 0}, {0}));
  CHECK_FALSE(PositionIn(triangle, Footprint({{{0, 0}, radius + 1e-6}}), {0, 0}, {0}));
}

// Points on the border of a footprint.
std::vector<Vector2d> BorderOf(const Footprint& footprint) {
  std::vector<Vector2d> points;
  for (const Disc& disc : footprint.discs()) {
    for (int i = 0; i < 64; ++i) {
      const double angle = 2 * M_PI * i / 64;
      points.push_back(disc.center + disc.radius * Vector2d(std::cos(angle), std::sin(angle)));
    }
  }
  return points;
}

bool Contains(const Region& region, const Vector2d& p, double tolerance) {
  const double margin = region.margin - tolerance;
  if (region.type == RegionType::kDisc) return p.norm() <= region.half_size.x() - margin;
  if (region.type == RegionType::kBox)
    return ((p.cwiseAbs() - region.half_size).array() <= -margin).all();
  for (std::size_t i = 0; i < region.corners.size(); ++i) {
    const Vector2d a = region.corners[i];
    const Vector2d edge = region.corners[(i + 1) % region.corners.size()] - a;
    const double inwards = edge.x() * (p - a).y() - edge.y() * (p - a).x();
    if (inwards < margin * edge.norm()) return false;
  }
  return true;
}

Region AnyRegion(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.1, 0.5);
  Region region = BoxRegion(uniform(random), uniform(random));
  if (random() % 3 == 0) region = DiscRegion(uniform(random));
  if (random() % 3 == 0) {
    Polygon corners;
    for (int i = 0; i < 7; ++i) corners.emplace_back(uniform(random) - 0.2, uniform(random) - 0.3);
    region = PolygonRegion(solid::ConvexPolygonOf(corners));
  }
  region.margin = random() % 2 == 0 ? 0 : 0.01;
  return region;
}

Footprint AnyFootprint(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-0.1, 0.1);
  std::vector<Disc> discs(1 + random() % 5);
  for (Disc& disc : discs)
    disc = {{uniform(random), uniform(random)}, random() % 2 == 0 ? 0 : std::abs(uniform(random))};
  return Footprint(discs);
}

TEST_CASE("every position in a random region keeps the footprint inside, and the last touches") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int fitting = 0;
  for (int i = 0; i < harness::Effort(300); ++i) {
    const Region region = AnyRegion(random);
    const Footprint footprint = AnyFootprint(random);
    Vector2d uv(uniform(random), uniform(random));
    const bool is_outermost = random() % 2 == 0;
    if (is_outermost) uv /= region.type == RegionType::kDisc ? uv.norm() : uv.cwiseAbs().maxCoeff();
    const auto at = PositionIn(region, footprint, uv, {0});
    const auto is_inside = [&](const Vector2d& t, double tolerance) {
      return std::ranges::all_of(BorderOf(footprint), [&](const Vector2d& p) {
        return Contains(region, p + t, tolerance);
      });
    };
    if (!at) {
      // No position of a grid is inside.
      for (int j = 0; j < 400; ++j)
        CHECK_FALSE(is_inside(0.05 * Vector2d(j % 20 - 10, j / 20 - 10), -1e-6));
      continue;
    }
    ++fitting;
    CHECK(is_inside(*at, 1e-7));
    CHECK(FitsAt(region, footprint, *at, {0}));
    if (!is_outermost) continue;
    int outside = 0;
    for (int j = 0; j < 16; ++j) {
      const Vector2d step(std::cos(j * M_PI / 8), std::sin(j * M_PI / 8));
      const Vector2d near = *at + 1e-5 * step;
      outside += FitsAt(region, footprint, near, {0}) ? 0 : 1;
    }
    CHECK(outside > 0);
  }
  CHECK(fitting > harness::Effort(90));
}

TEST_CASE("a share of the footprint may be outside") {
  const Region region = BoxRegion(0.5, 0.3);
  const Footprint footprint = Rectangle(0.1, 0.05);
  const auto at = [&](double u, double v) {
    return *PositionIn(region, footprint, {u, v}, {0.25});
  };
  // A quarter of its length of 0.2.
  CHECK((at(1, 0) - Vector2d(0.45, 0)).norm() < 1e-9);
  CHECK((at(0, -0.5) - Vector2d(0, -0.275 / 2)).norm() < 1e-9);
  CHECK(FitsAt(region, footprint, {0.4499, 0}, {0.25}));
  CHECK_FALSE(FitsAt(region, footprint, {0.4501, 0}, {0.25}));
  // At a corner, the shares of both sides inside are multiplied.
  const Vector2d corner = at(1, 1);
  const Vector2d inside = (Vector2d(0.6, 0.35) - corner).cwiseQuotient(Vector2d(0.2, 0.1));
  CHECK(inside.cwiseMin(1).prod() == Approx(0.75));
  // A plank longer than the region.
  CHECK_FALSE(PositionIn(region, Rectangle(0.6, 0.1), {0, 0}, {0}));
  CHECK(PositionIn(region, Rectangle(0.6, 0.1), {0, 0}, {0.2}));
  CHECK_FALSE(PositionIn(region, Rectangle(0.6, 0.1), {0, 0}, {0.1}));
}

}  // namespace
}  // namespace mjforge::placing
