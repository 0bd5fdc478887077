// Footprints of shapes, against closed forms and sampled points.
#include "mjforge/placing/footprint.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "harness/effort.h"
#include "mjforge/solid/solid.h"
#include "scene.h"

namespace mjforge::placing {
namespace {

using distance::PlacedShape;
using Eigen::Vector2d;
using Eigen::Vector3d;
using model::GeomType;
using model::Pose;

Vector2d UnitAt(double angle) { return {std::cos(angle), std::sin(angle)}; }

Pose Lying(double z) { return {{0, 0, z}, model::FromAxisAngle(Vector3d::UnitY(), M_PI / 2)}; }

// Checks the support function of a footprint along the axes and a diagonal.
void CheckSupport(const std::vector<PlacedShape>& shapes, double x, double y, double diagonal,
                  double tolerance = 1e-12) {
  const Footprint footprint = FootprintOf(shapes);
  CHECK(std::abs(footprint.Support({1, 0}) - x) < tolerance);
  CHECK(std::abs(footprint.Support({-1, 0}) - x) < tolerance);
  CHECK(std::abs(footprint.Support({0, 1}) - y) < tolerance);
  CHECK(std::abs(footprint.Support(UnitAt(M_PI / 4)) - diagonal) < tolerance);
}

TEST_CASE("the footprint of one shape has a closed form") {
  const double cap = std::sqrt(0.05 * 0.05 - 0.049 * 0.049);  // of a ball, 1 mm high
  const double root = std::sqrt(0.5);
  CheckSupport({{ShapeOf(GeomType::kBox, 0.1, 0.2, 0.3), At(0, 0, 1)}}, 0.1, 0.2, 0.3 * root);
  CheckSupport({{ShapeOf(GeomType::kCylinder, 0.1, 0.3), At(0, 0, 1)}}, 0.1, 0.1, 0.1);
  CheckSupport({{ShapeOf(GeomType::kSphere, 0.05), At(0, 0, 0)}}, cap, cap, cap);
  CheckSupport({{ShapeOf(GeomType::kCapsule, 0.05, 0.1), At(0, 0, 0)}}, cap, cap, cap);
  CheckSupport({{ShapeOf(GeomType::kEllipsoid, 0.05, 0.05, 0.05), At(0, 0, 0)}}, cap, cap, cap);
  CheckSupport({{ShapeOf(GeomType::kCapsule, 0.05, 0.1), Lying(0)}}, 0.1 + cap, cap,
               0.1 * root + cap);
  CheckSupport({{ShapeOf(GeomType::kCylinder, 0.05, 0.1), Lying(0)}}, 0.1, cap, (0.1 + cap) * root);
  // An ellipsoid's slice is an ellipse with half axes a, b times sqrt(1 - (1 - 1 mm / c)^2).
  const double share = std::sqrt(1 - std::pow(1 - 1e-3 / 0.02, 2));
  CheckSupport({{ShapeOf(GeomType::kEllipsoid, 0.1, 0.05, 0.02), At(0, 0, 0)}}, share * 0.1,
               share * 0.05, share * std::sqrt((0.01 + 0.0025) / 2), 1e-12);
}

TEST_CASE("higher parts and visual handles do not count") {
  const PlacedShape leg(ShapeOf(GeomType::kBox, 0.01, 0.01, 0.1), At(0.2, 0, 0.1));
  const PlacedShape other(ShapeOf(GeomType::kBox, 0.01, 0.01, 0.1), At(-0.2, 0, 0.1005));
  const PlacedShape top(ShapeOf(GeomType::kBox, 0.5, 0.5, 0.01), At(0, 0, 0.21));
  CheckSupport({leg, other, top}, 0.21, 0.01, 0.22 * std::sqrt(0.5));
}

TEST_CASE("a body without shapes stands in its origin") {
  const Footprint footprint = FootprintOf({});
  CHECK(footprint.Support({1, 0}) == 0);
  CHECK(footprint.Outline().size() == 1);
}

TEST_CASE("a footprint turns with its body") {
  const PlacedShape box(ShapeOf(GeomType::kBox, 0.1, 0.2, 0.3), At(0.5, 0, 1));
  const Footprint turned = FootprintOf(std::vector{box}).Turned(M_PI / 2);
  CHECK(turned.Box().min().isApprox(Vector2d(-0.2, 0.4)));
  CHECK(turned.Box().max().isApprox(Vector2d(0.2, 0.6)));
}

// A mesh with many vertices is sliced at the edges of its hull, a smaller one pairwise.
TEST_CASE("a mesh's footprint is the same with few and with many vertices") {
  solid::TriangleMesh small;
  solid::TriangleMesh large;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 60; ++i)
    small.vertices.push_back(Vector3d(uniform(random), uniform(random), 0.002 * uniform(random)));
  for (int i = 0; i < 1500; ++i) {
    const Vector3d a = small.vertices[random() % 60];
    const Vector3d b = small.vertices[random() % 60];
    large.vertices.push_back((a + b) / 2);
  }
  large.vertices.insert(large.vertices.end(), small.vertices.begin(), small.vertices.end());
  const auto footprint = [](const solid::TriangleMesh& mesh) {
    return FootprintOf(std::vector{PlacedShape({GeomType::kMesh, Vector3d::Zero(), &mesh}, {})});
  };
  for (int i = 0; i < 64; ++i) {
    const Vector2d direction = UnitAt(i * M_PI / 32);
    CHECK(std::abs(footprint(small).Support(direction) - footprint(large).Support(direction)) <
          1e-9);
  }
}

TEST_CASE("footprints of random shapes contain all low points and are not larger than needed") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::array types = {GeomType::kSphere, GeomType::kCapsule, GeomType::kEllipsoid,
                            GeomType::kCylinder, GeomType::kBox};
  for (int i = 0; i < harness::Effort(100); ++i) {
    Pose X;
    X.q = Eigen::Quaterniond(uniform(random) - 0.5, uniform(random) - 0.5, uniform(random) - 0.5,
                             uniform(random) - 0.5)
              .normalized();
    const PlacedShape placed(ShapeOf(types[random() % 5], 0.01 + 0.05 * uniform(random),
                                     0.01 + 0.05 * uniform(random), 0.01 + 0.05 * uniform(random)),
                             X);
    const double level = placed.box_W.min().z() + 1e-3;
    const Footprint footprint = FootprintOf(std::vector{placed});
    for (int j = 0; j < 16; ++j) {
      // Duality: the farthest point below a plane is the least farthest point of tilted directions.
      const Vector2d direction = UnitAt(2 * M_PI * j / 16);
      const auto farthest_at = [&](double angle) {
        const Vector3d way(direction.x(), direction.y(), -std::tan(angle));
        return way.dot(FarthestPoint(placed, way)) + std::tan(angle) * level;
      };
      double low = 0;
      double high = 1.5707;
      while (high - low > 1e-9) {
        const double a = low + (high - low) / 3;
        const double b = high - (high - low) / 3;
        if (farthest_at(a) > farthest_at(b)) {
          low = a;
        } else {
          high = b;
        }
      }
      const double farthest = farthest_at(low);
      CAPTURE(model::GeomTypeName(placed.shape.type), farthest);
      CHECK(std::abs(footprint.Support(direction) - farthest) < 1e-4);
    }
  }
}

}  // namespace
}  // namespace mjforge::placing
