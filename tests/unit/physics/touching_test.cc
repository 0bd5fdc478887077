#include "mjforge/physics/touching.h"

#include <catch2/catch.hpp>

namespace mjforge::physics {
namespace {

using model::GeomType;

using model::Part;

Part At(GeomType type, const Eigen::Vector3d& size, const Eigen::Vector3d& pos) {
  Part solid;
  solid.shape = {type, size, nullptr};
  solid.X_BG.p = pos;
  solid.mass = model::Volume(solid.shape);
  return solid;
}

TEST_CASE("solids touch up to the gap between their surfaces") {
  const double scale = GENERATE(1e-4, 1.0, 100.0);
  CAPTURE(scale);
  const auto solid = [&](GeomType type, const Eigen::Vector3d& size, double x) {
    return At(type, scale * size, {scale * x, 0, 0});
  };
  const Part ball = solid(GeomType::kSphere, {1, 0, 0}, 0);
  const Part others[] = {
      solid(GeomType::kSphere, {0.5, 0, 0}, 1.6), solid(GeomType::kBox, {0.5, 2, 3}, 1.6),
      solid(GeomType::kCylinder, {0.5, 1, 0}, 1.6), solid(GeomType::kCapsule, {0.5, 1, 0}, 1.6),
      solid(GeomType::kEllipsoid, {0.5, 2, 1}, 1.6)};
  for (const Part& other : others) {
    CAPTURE(model::GeomTypeName(other.shape.type));
    CHECK_FALSE(Touch(ball, other, 0.098 * scale));  // they are 0.1 apart
    CHECK(Touch(ball, other, 0.102 * scale));
    CHECK(Touch(other, ball, 0.102 * scale));
  }
}

TEST_CASE("a part inside another touches it") {
  CHECK(Touch(At(GeomType::kBox, {1, 1, 1}, {0, 0, 0}),
              At(GeomType::kSphere, {0.1, 0, 0}, {0, 0, 0}), 1e-6));
}

TEST_CASE("pieces are what holds together, the heaviest first") {
  const std::vector<Part> parts = {
      At(GeomType::kBox, {1, 1, 1}, {10, 0, 0}), At(GeomType::kBox, {2, 1, 1}, {0, 0, 0}),
      At(GeomType::kBox, {1, 1, 1}, {-3, 0, 0}), At(GeomType::kSphere, {0.1, 0, 0}, {-4.1, 0, 0})};
  const std::vector<std::vector<std::size_t>> expected = {{1, 2, 3}, {0}};
  CHECK(Pieces(parts, 0.001) == expected);
  CHECK(Pieces(parts, 7.1).size() == 1);
}

TEST_CASE("the nearest part outside a group, and how far it is") {
  const std::vector<Part> parts = {At(GeomType::kBox, {1, 1, 1}, {0, 0, 0}),
                                   At(GeomType::kSphere, {1, 0, 0}, {10, 0, 0}),
                                   At(GeomType::kBox, {1, 1, 1}, {5, 0, 0})};
  const Neighbour nearest = NearestOf(parts, {0, 1}, 0.001);
  CHECK(nearest.part == 2);
  CHECK(nearest.distance == Approx(3).epsilon(0.01));
}

TEST_CASE("a centre of mass between separate parts is inside their hull") {
  const std::vector<Part> parts = {At(GeomType::kSphere, {1, 0, 0}, {-5, 0, 0}),
                                   At(GeomType::kSphere, {1, 0, 0}, {5, 0, 0})};
  CHECK(IsInsideHull(parts, {0, 0, 0}));
  CHECK(IsInsideHull(parts, {0, 0.99, 0}));
  CHECK_FALSE(IsInsideHull(parts, {0, 1.05, 0}));
  CHECK_FALSE(IsInsideHull(parts, {6.1, 0, 0}));
}

}  // namespace
}  // namespace mjforge::physics
