// Tests of distances to obstacles, and of lowering objects onto obstacles.
#include "mjforge/placing/obstacles.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "harness/effort.h"
#include "scene.h"

namespace mjforge::placing {
namespace {

using distance::PlacedShape;
using Eigen::Vector3d;
using model::GeomType;

// Returns the drop of one shape onto another.
double Drop(const model::Shape& moving, const model::Pose& from, const model::Shape& fixed,
            const model::Pose& at) {
  Scene scene;
  scene.Add(fixed, at);
  Obstacles obstacles;
  obstacles.Add(scene.object, 0, 0);
  return obstacles.Drop({PlacedShape(moving, from)}, Vector3d::UnitZ(), 10);
}

TEST_CASE("the drop until round and flat shapes touch has a closed form") {
  const auto ball = ShapeOf(GeomType::kSphere, 0.5);
  const auto box = ShapeOf(GeomType::kBox, 1, 1, 1);
  const auto capsule = ShapeOf(GeomType::kCapsule, 0.5, 1);
  CHECK(std::abs(Drop(ball, At(0, 0, 4), ball, At(0, 0, 0)) - 3) < 1e-6);
  CHECK(std::abs(Drop(ball, At(0.6, 0, 4), ball, At(0, 0, 0)) - 3.2) < 1e-6);
  CHECK(std::abs(Drop(ball, At(0.9, -0.9, 4), box, At(0, 0, 0)) - 2.5) < 1e-6);
  // On the edge of the box: 0.3 beyond it, 0.4 above it.
  CHECK(std::abs(Drop(ball, At(1.3, 0, 4), box, At(0, 0, 0)) - 2.6) < 1e-6);
  CHECK(std::abs(Drop(capsule, At(0.3, 0.4, 4), box, At(0, 0, 0)) - 1.5) < 1e-6);
}

TEST_CASE("shapes drop along a wall and past other things without touching them") {
  const auto box = ShapeOf(GeomType::kBox, 1, 1, 1);
  CHECK(Drop(box, At(2.001, 0, 4), box, At(0, 0, 0)) == 10);
  CHECK(Drop(box, At(2.0001, 0, 0), box, At(0, 0, 0)) == 10);
  CHECK(Drop(ShapeOf(GeomType::kSphere, 0.5), At(1.51, 0, 4), box, At(0, 0, 0)) == 10);
  CHECK(Drop(box, At(1.5, 0, 0), box, At(0, 0, 0)) == 0);
}

// Returns a random shape at a random pose, at this height.
PlacedShape AnyShape(std::mt19937& random, double z) {
  constexpr std::array kTypes = {GeomType::kSphere, GeomType::kCapsule, GeomType::kEllipsoid,
                                 GeomType::kCylinder, GeomType::kBox};
  std::uniform_real_distribution<double> uniform(-1, 1);
  model::Pose X = At(uniform(random), uniform(random), z);
  X.q = Eigen::Quaterniond(uniform(random), uniform(random), uniform(random), 1.5).normalized();
  const auto size = [&] { return 0.6 + 0.5 * uniform(random); };
  return {ShapeOf(kTypes[random() % 5], size(), size(), size()), X};
}

TEST_CASE("random shapes touch after the drop and nowhere before") {
  std::mt19937 random(11);
  int touching = 0;
  for (int i = 0; i < harness::Effort(300); ++i) {
    const PlacedShape moving = AnyShape(random, 6);
    const PlacedShape fixed = AnyShape(random, 0);
    const double drop = Drop(moving.shape, moving.X_WG, fixed.shape, fixed.X_WG);
    const auto distance_at = [&](double way) {
      model::Pose X = moving.X_WG;
      X.p.z() -= way;
      return distance::Distance(PlacedShape(moving.shape, X), fixed);
    };
    for (int j = 0; j < 50; ++j) CHECK(distance_at(drop * j / 50) > 0);
    if (drop == 10) continue;
    ++touching;
    CHECK(distance_at(drop) < 1e-6);
  }
  CHECK(touching > harness::Effort(100));
}

TEST_CASE("boxes of moved shapes contain the shapes") {
  std::mt19937 random(12);
  for (int i = 0; i < harness::Effort(100); ++i) {
    const PlacedShapes shapes_L = {AnyShape(random, 0), AnyShape(random, 1), AnyShape(random, 2)};
    const model::Pose X_WL = AnyShape(random, 3).X_WG;
    const MovedShapes moved(shapes_L, X_WL);
    for (std::size_t j = 0; j < shapes_L.size(); ++j) {
      const PlacedShape expected(shapes_L[j].shape, X_WL * shapes_L[j].X_WG);
      CHECK(moved.At(j).shape.type == expected.shape.type);
      CHECK(moved.At(j).X_WG.p == expected.X_WG.p);
      CHECK(moved.At(j).X_WG.q.coeffs() == expected.X_WG.q.coeffs());
      CHECK(moved.box_W(j).contains(expected.box_W));
      CHECK(moved.box_W().contains(moved.box_W(j)));
    }
  }
}

TEST_CASE("a blocker overlaps, or is nearer than either body asks for") {
  Scene scene;
  const auto box = ShapeOf(GeomType::kBox, 0.1, 0.1, 0.1);
  const int first = scene.Add(box, At(0, 0, 0.1));
  const int second = scene.Add(box, At(1, 0, 0.1));
  const int inner = scene.Add(box, At(0.5, 0, 0), second);
  Obstacles obstacles;
  obstacles.Add(scene.object, first, 0);
  obstacles.Add(scene.object, second, 0.05);
  const Support floor{-1, Vector3d::Zero(), Vector3d::UnitZ()};
  const auto blocker = [&](double x, double clear) {
    const PlacedShapes shapes_L = {PlacedShape(box, {})};
    return obstacles.FindBlocker({shapes_L, At(x, 0, 0.1)}, clear, floor);
  };
  CHECK_FALSE(blocker(0.21, 0));
  CHECK(blocker(0.21, 0.02)->body == first);
  CHECK(blocker(0.21, 0.02)->distance == Approx(0.01));
  CHECK(blocker(0.1, 0)->distance == 0);
  CHECK_FALSE(blocker(0.749, 0));
  CHECK(blocker(0.76, 0)->body == second);
  CHECK(blocker(1.72, 0)->body == inner);
  CHECK_FALSE(blocker(1.76, 0.05));
}

TEST_CASE("the support and what is below it must only not overlap") {
  Scene scene;
  const int top = scene.Add(ShapeOf(GeomType::kBox, 1, 1, 0.1), At(0, 0, -0.1));
  scene.Add(ShapeOf(GeomType::kBox, 1, 1, 0.1), At(0, 0, -0.1), top);
  Obstacles obstacles;
  obstacles.Add(scene.object, top, 0);
  const auto ball = ShapeOf(GeomType::kSphere, 0.1);
  const Support support{top, Vector3d::Zero(), Vector3d::UnitZ()};
  const auto is_blocked = [&](double z) {
    const PlacedShapes shapes_L = {PlacedShape(ball, {})};
    return obstacles.FindBlocker({shapes_L, At(0, 0, z)}, 0.05, support).has_value();
  };
  CHECK_FALSE(is_blocked(0.1 + 1e-6));
  CHECK(is_blocked(0.1 - 1e-6));
}

}  // namespace
}  // namespace mjforge::placing
