// Tests of the horizontal radius of shapes.

#include <random>

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

TEST_CASE("upright shapes on the axis have their own radius") {
  CHECK(HorizontalRadius({.type = GeomType::kCylinder, .size = {2, 9, 0}}, {}) == 2);
  CHECK(HorizontalRadius({.type = GeomType::kEllipsoid, .size = {2, 3, 9}}, {}) == 3);
  CHECK(HorizontalRadius({.type = GeomType::kSphere, .size = {2, 0, 0}}, {}) == 2);
  CHECK(HorizontalRadius({.type = GeomType::kCapsule, .size = {2, 9, 0}}, {}) == 2);
  CHECK(HorizontalRadius({.type = GeomType::kBox, .size = {3, 4, 9}}, {}) == 5);
}

TEST_CASE("a lying cylinder's farthest points are on its rims") {
  const Pose lying = {.q = FromEuler({0, M_PI / 2, 0})};
  const double radius = HorizontalRadius({.type = GeomType::kCylinder, .size = {3, 4, 0}}, lying);
  CHECK(radius == Approx(5).epsilon(1e-14));
}

// The farthest point is on the minor axis if the curvature is small enough.
TEST_CASE("an ellipsoid off the axis along its short half axis is farthest off to both sides") {
  const Shape ellipsoid = {.type = GeomType::kEllipsoid, .size = {2, 1, 1}};
  // x = 2 cos t, y = 0.5 + sin t: 4 - 3 s^2 + s + 0.25 is largest at s = 1/6.
  const double radius = HorizontalRadius(ellipsoid, {.p = {0, 0.5, 0}});
  CHECK(radius == Approx(std::sqrt(4.25 + 1 / 12.0)).epsilon(1e-14));
  CHECK(HorizontalRadius(ellipsoid, {.p = {0, 10, 0}}) == Approx(11).epsilon(1e-14));
  CHECK(HorizontalRadius(ellipsoid, {.p = {1e-30, 0.5, 0}}) == Approx(radius).epsilon(1e-14));
  CHECK(HorizontalRadius(ellipsoid, {.p = {1e-12, 0.5, 0}}) == Approx(radius).epsilon(1e-11));
}

// Returns the largest support in 20,000 horizontal directions. The largest distance from a line is
// the largest support in any direction across the line, and the relative error of the nearest
// direction is at most 1 - cos(pi / 20000).
template <typename Solid>
double RadiusBySupport(const Solid& solid, const Pose& X_AG) {
  double largest = 0;
  const Eigen::Matrix3d R_GA = X_AG.q.toRotationMatrix().transpose();
  for (int i = 0; i < 20000; ++i) {
    const double angle = 2 * M_PI * i / 20000;
    const Eigen::Vector3d d(std::cos(angle), std::sin(angle), 0);
    largest = std::max(largest, d.dot(X_AG.p) + Support(solid, R_GA * d));
  }
  return largest;
}

TEST_CASE("the radius of any shape at any pose is its largest support across the axis") {
  std::mt19937 random(7);
  const auto draw = [&random](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random()) / 4294967296.0;
  };
  const std::vector<Eigen::Vector2d> corners = {{0, 0}, {1, 0}, {0.5, 2}};
  const std::optional<TriangleMesh> mesh = solid::MakeConvexPrism(corners, 1);
  REQUIRE(mesh);
  for (int i = 0; i < harness::Effort(100); ++i) {
    Shape shape;
    shape.type = static_cast<GeomType>(i % 6);
    shape.size = {draw(0.01, 1), draw(0.01, 1), draw(0.01, 1)};
    shape.mesh = &*mesh;
    const double away = i % 7 == 0 ? 0 : draw(0, 1);
    const Pose X_AG = {.p = {away * draw(-1, 1), away * draw(-1, 1), draw(-1, 1)},
                       .q = FromEuler({draw(-4, 4), draw(-4, 4), draw(-4, 4)})};
    const double sampled = RadiusBySupport(shape, X_AG);
    const double exact = HorizontalRadius(shape, X_AG);
    INFO(GeomTypeName(shape.type) << " " << i);
    CHECK(exact >= sampled - 1e-14);
    CHECK(exact <= sampled * (1 + 1e-6) + 1e-14);
  }
}

TEST_CASE("the radius of curves at any pose is their largest support across the axis") {
  std::mt19937 random(8);
  const auto draw = [&random](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random()) / 4294967296.0;
  };
  for (int i = 0; i < harness::Effort(100); ++i) {
    solid::Extent extent;
    const Eigen::Vector3d center(draw(-1, 1), draw(-1, 1), draw(-1, 1));
    solid::AddLevelArc(center, draw(0, 1), draw(-4, 4), i % 2 == 0 ? 2 * M_PI : draw(0.1, 6),
                       extent);
    if (i % 4 == 0) extent.front().round = draw(0, 0.1);
    const double away = i % 7 == 0 ? 0 : draw(0, 1);
    const Pose X_AS = {.p = {away * draw(-1, 1), away * draw(-1, 1), draw(-1, 1)},
                       .q = FromEuler({draw(-4, 4), draw(-4, 4), draw(-4, 4)})};
    const double sampled = RadiusBySupport(extent, X_AS);
    const double exact = HorizontalRadius(extent, X_AS);
    INFO(i);
    CHECK(exact >= sampled - 1e-14);
    CHECK(exact <= sampled * (1 + 1e-6) + 1e-14);
  }
  solid::Extent points = solid::ExtentOf(std::array<Eigen::Vector3d, 1>{{{3, 4, 5}}}, 0.5);
  CHECK(HorizontalRadius(points, {}) == 5.5);
  CHECK(HorizontalRadius(solid::Extent(), {}) == 0);
  CHECK(BoundsOf(solid::Extent(), {}).empty());
}

}  // namespace
}  // namespace mjforge::model
