// Distances and penetration depths of convex shapes, and distances from convex hulls.
#include "mjforge/distance/distance.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "harness/effort.h"

namespace mjforge::distance {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using model::GeomType;
using model::Pose;
using model::Shape;

Shape ShapeOf(GeomType type, const Vector3d& size) { return {type, size, nullptr}; }

double Between(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  return SignedDistance({a, X_WA}, {b, X_WB});
}

TEST_CASE("the distance of round shapes is that of their axes, less their radii") {
  const double scale = GENERATE(1e-3, 1.0, 1e3);
  CAPTURE(scale);
  const auto shape = [&](GeomType type, const Vector3d& size) {
    return ShapeOf(type, scale * size);
  };
  const auto at = [&](double x, double y, double z) {
    Pose X;
    X.p = Vector3d(scale * Vector3d(x, y, z));
    return X;
  };
  const Shape ball = shape(GeomType::kSphere, {1, 0, 0});
  const Shape capsule = shape(GeomType::kCapsule, {0.5, 2, 0});
  const Shape cylinder = shape(GeomType::kCylinder, {0.5, 2, 0});
  const Shape box = shape(GeomType::kBox, {1, 2, 3});
  const Shape egg = shape(GeomType::kEllipsoid, {1, 2, 3});
  const auto check = [&](const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                         double wanted) {
    CHECK(std::abs(Between(a, X_WA, b, X_WB) - scale * wanted) <= 1e-8 * scale);
    CHECK(std::abs(Between(b, X_WB, a, X_WA) - scale * wanted) <= 1e-8 * scale);
  };
  check(ball, at(0, 0, 0), ball, at(3, 4, 0), 3);
  check(ball, at(0, 0, 0), capsule, at(3, 4, 1), 3.5);
  check(ball, at(0, 0, 0), cylinder, at(3, 4, 1), 3.5);
  check(ball, at(0, 0, 0), cylinder, at(0, 0, 4), 1);
  // Nearest point on the rim.
  check(ball, at(0, 0, 0), cylinder, at(3.5, 0, 6), 4);
  check(ball, at(0, 0, 0), box, at(4, 0, 0), 2);
  check(ball, at(0, 0, 0), box, at(4, 6, 3), 4);
  check(ball, at(0, 0, 0), egg, at(0, 0, 5), 1);
  check(box, at(0, 0, 0), box, at(2.5, 0, 0), 0.5);
  check(box, at(0, 0, 0), box, at(2 + 3, 4 + 4, 0), 5);
  check(box, at(0, 0, 0), cylinder, at(2, 0, 0), 0.5);
  check(egg, at(0, 0, 0), egg, at(2.25, 0, 0), 0.25);
}

TEST_CASE("what overlaps has less than no distance") {
  const Shape box = ShapeOf(GeomType::kBox, {1, 1, 1});
  Pose X;
  X.p = Vector3d(1.9, 0, 0);
  CHECK(Between(box, {}, box, X) == Approx(-0.1).margin(1e-6));
  X.p = Vector3d(2, 0.3, 0.4);
  CHECK(std::abs(Between(box, {}, box, X)) < 1e-9);
  const Shape ball = ShapeOf(GeomType::kSphere, {1, 0, 0});
  X.p = Vector3d(1.5, 0, 0);
  CHECK(Between(ball, {}, ball, X) == Approx(-0.5).margin(1e-4));
  CHECK(Between(ball, {}, box, {}) < -0.9);
}

// Separating planes bound the distance from below, points of B from above.
TEST_CASE("the distance of turned solids is between what bounds it") {
  std::mt19937 random(7);
  const auto uniform = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random()) / 4294967296.0;
  };
  constexpr GeomType kTypes[] = {GeomType::kBox, GeomType::kCylinder, GeomType::kCapsule,
                                 GeomType::kEllipsoid, GeomType::kSphere};
  int apart = 0;
  for (int i = 0; i < harness::Effort(2000); ++i) {
    CAPTURE(i);
    const auto any = [&] {
      return ShapeOf(kTypes[random() % 5], {uniform(0.01, 1), uniform(0.01, 1), uniform(0.01, 1)});
    };
    const auto anywhere = [&] {
      Pose X;
      X.p = Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      X.q =
          Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)).normalized();
      return X;
    };
    const Shape a = any();
    const Shape b = any();
    const PlacedShape A = {a, anywhere()};
    const PlacedShape B = {b, anywhere()};
    const double distance = SignedDistance(A, B);
    const double again = SignedDistance(B, A);
    CHECK(std::abs(again - distance) <= (distance > 0 ? 1e-8 : 1e-4));
    if (distance <= 0) continue;
    ++apart;
    // A distance that is too large to matter is only found to be so.
    CHECK(DistanceUpTo(2 * distance, A, B) == Distance(A, B));
    CHECK(DistanceUpTo(distance / 2, A, B) > distance / 2);
    // The largest separation of parallel support planes is at most the distance.
    double separation = -1;
    Vector3d direction = Vector3d::UnitX();
    for (int j = 0; j < 300; ++j) {
      const Vector3d d = Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
      const double gap = d.dot(FarthestPoint(B, -d)) - d.dot(FarthestPoint(A, d));
      if (gap > separation) {
        separation = gap;
        direction = d;
      }
    }
    CHECK(separation <= distance + 1e-9);
    // A point of B is at least the distance away from A.
    const Vector3d from = FromHull(std::array{A}, FarthestPoint(B, -direction));
    CHECK(from.norm() >= distance - 1e-9);
  }
  CHECK(apart > harness::Effort(300));
}

TEST_CASE("a point in the hull of several solids is at no distance from it") {
  const Shape ball = ShapeOf(GeomType::kSphere, {0.5, 0, 0});
  std::vector<PlacedShape> two = {{ball, {}}, {ball, {}}};
  two[1].X_WG.p = Vector3d(4, 0, 0);
  CHECK(FromHull(two, {2, 0, 0}).norm() == 0);
  CHECK(FromHull(two, {2, 0.4999, 0}).norm() == 0);
  CHECK((FromHull(two, {2, 0.75, 0}) - Vector3d(0, 0.25, 0)).norm() < 1e-8);
  CHECK((FromHull(two, {5, 0, 0}) - Vector3d(0.5, 0, 0)).norm() < 1e-8);
  CHECK(std::abs(FromHull(two, {-3, 4, 0}).norm() - 4.5) < 1e-8);
}

TEST_CASE("round things around one middle are as deep as their radii say") {
  const auto depth = [](GeomType a, const Vector3d& size_a, GeomType b, const Vector3d& size_b,
                        const Vector3d& offset) {
    Pose X;
    X.p = offset;
    return -Between(ShapeOf(a, size_a), Pose(), ShapeOf(b, size_b), X);
  };
  const Vector3d here = Vector3d::Zero();
  for (const double big : {0.002, 0.009, 0.02, 0.03, 0.1, 1.0}) {
    CAPTURE(big);
    const Vector3d radius(big, 0, 0);
    CHECK(depth(GeomType::kSphere, {0.002, 0, 0}, GeomType::kSphere, radius, here) ==
          Approx(0.002 + big).epsilon(1e-9));
    CHECK(depth(GeomType::kSphere, {0.002, 0, 0}, GeomType::kSphere, radius, {1e-5, 0, 0}) ==
          Approx(0.002 + big - 1e-5).epsilon(1e-9));
    CHECK(depth(GeomType::kCapsule, {0.01, 0.0001, 0}, GeomType::kSphere, radius, here) ==
          Approx(0.01 + big).epsilon(1e-9));
  }
  CHECK(depth(GeomType::kEllipsoid, {0.01, 0.01, 0.01001}, GeomType::kSphere, {0.04, 0, 0}, here) ==
        Approx(0.05).epsilon(1e-6));
  CHECK(depth(GeomType::kEllipsoid, {0.01, 0.011, 0.012}, GeomType::kEllipsoid,
              {0.02, 0.022, 0.019}, here) == Approx(0.03).epsilon(0.03));
  CHECK(depth(GeomType::kCylinder, {0.01, 0.05, 0}, GeomType::kCylinder, {0.02, 0.05, 0}, here) ==
        Approx(0.03).epsilon(1e-4));
  CHECK(depth(GeomType::kBox, {0.01, 0.02, 0.03}, GeomType::kSphere, {0.04, 0, 0}, here) ==
        Approx(0.05).epsilon(1e-4));
}

}  // namespace
}  // namespace mjforge::distance
