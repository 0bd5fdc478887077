// Widest gaps between bodies that stand in a region, beside closed forms.

#include "mjforge/placing/widest_gap.h"

#include <cmath>

#include <catch2/catch.hpp>

#include "scene.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector3d;
using model::GeomType;

constexpr double kPrecision = 2e-3;  // m, of a diameter

// Returns the widest gap of an area at the height 0 for a body of this height.
double GapOf(const model::Region& region, const Scene& scene, double height = 0.1) {
  Obstacles obstacles;
  for (std::size_t i = 0; i < scene.object.bodies.size(); ++i)
    obstacles.Add(scene.object, static_cast<int>(i), 0);
  return WidestGap(region, {}, height, obstacles, {-1, Vector3d::Zero(), Vector3d::UnitZ()});
}

TEST_CASE("the widest gap of an empty region is its largest disc") {
  CHECK(std::abs(GapOf(BoxRegion(0.4, 0.2), Scene()) - 0.4) < kPrecision);
  model::Region disc = BoxRegion(0.3, 0.3);
  disc.type = model::RegionType::kDisc;
  disc.margin = 0.05;
  CHECK(std::abs(GapOf(disc, Scene()) - 0.5) < kPrecision);
  model::Region triangle = BoxRegion(0.3, 0.2);
  triangle.type = model::RegionType::kPolygon;
  triangle.corners = {{0, 0}, {0.4, 0}, {0, 0.3}};
  CHECK(std::abs(GapOf(triangle, Scene()) - 0.2) < kPrecision);
}

TEST_CASE("the widest gap is between the bodies that stand") {
  Scene scene;
  scene.Add(ShapeOf(GeomType::kCylinder, 0.1, 0.05), At(0, 0, 0.05));
  // A disc in each corner touches two edges and the cylinder.
  const double radius = (0.2 * std::sqrt(2) - 0.1) / (1 + std::sqrt(2));
  CHECK(std::abs(GapOf(BoxRegion(0.2, 0.2), scene) - 2 * radius) < kPrecision);
}

TEST_CASE("a lamp that hangs over a region limits only what reaches it") {
  Scene scene;
  scene.Add(ShapeOf(GeomType::kBox, 0.2, 0.2, 0.1), At(0, 0, 0.4));
  CHECK(std::abs(GapOf(BoxRegion(0.2, 0.2), scene, 0.2) - 0.4) < kPrecision);
  CHECK(GapOf(BoxRegion(0.2, 0.2), scene, 0.35) == 0);
}

}  // namespace
}  // namespace mjforge::placing
