// Tests of the convex hulls of solids, against closed forms and render meshes.

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "reference_geometry.h"

namespace mjforge::solid {
namespace {

Vector3d RandomDirection(Random& random) {
  return Vector3d(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1)).normalized();
}

TEST_CASE("a turned cup reaches as far as the circles of its profile, in every direction") {
  const std::vector<Vector2d> line = {{0, 0}, {.03, 0}, {.035, .08}};
  const Vector2d along = (line[2] - line[1]).normalized();
  // The wall ends across its line.
  const Vector2d inner = line[2] + .002 * Vector2d(-along.y(), along.x());
  const Solid walled = Made(Lathe{.profile = line, .wall = .002});
  const Solid solid = Made(Lathe{.profile = {line[0], line[1], line[2], {0, .08}}});
  const Solid whole = Made(RoundedCylinder{.radius = .04, .half = .03, .round = .01});
  Random random(41);
  for (int i = 0; i < harness::Effort(1000); ++i) {
    const Vector3d d = RandomDirection(random);
    const double across = d.head<2>().norm();
    const auto at = [&](const Vector2d& p) { return p.x() * across + p.y() * d.z(); };
    const double outside = std::max({at(line[0]), at(line[1]), at(line[2])});
    CHECK(std::abs(Support(walled.extent, d) - std::max(outside, at(inner))) < 1e-12);
    CHECK(std::abs(Support(solid.extent, d) - std::max(outside, at({0, .08}))) < 1e-12);
    const double round = .03 * across + .02 * std::abs(d.z()) + .01;
    CHECK(std::abs(Support(whole.extent, d) - round) < 1e-12);
  }
}

TEST_CASE("a part turn reaches as far as its arcs and their ends") {
  const Solid half = Made(Lathe{.profile = {{1, 0}, {2, 0}, {2, 1}, {1, 1}}, .angle = kPi});
  CHECK(Support(half.extent, {0, 1, 0}) == Approx(2));
  CHECK(Support(half.extent, {1, 0, 0}) == Approx(2));
  CHECK(Support(half.extent, {0, -1, 0}) == Approx(0).margin(1e-12));
  CHECK(Support(half.extent, {-1, 0, 2}) == Approx(4));
  CHECK(Support(half.extent, Vector3d(-1, -1, 0)) == Approx(2));
}

TEST_CASE("rounded boxes and hulls reach as far as their core, and the rounding further") {
  Random random(42);
  for (int i = 0; i < harness::Effort(300); ++i) {
    const Vector3d half(random.Uniform(0.1, 1), random.Uniform(0.1, 1), random.Uniform(0.1, 1));
    const double r = random.Uniform(0.01, 0.95) * half.minCoeff();
    const Vector3d d = RandomDirection(random);
    const Vector3d core = half.array() - r;
    const Solid box = Made(RoundedBox{.half = half, .round = r});
    CHECK(std::abs(Support(box.extent, d) - core.dot(d.cwiseAbs()) - r) < 1e-12);
  }
}

/// Checks that the solid and its render mesh have the same convex hull up to `tolerance`, m. The
/// vertices of the mesh are points of the surface, rounded to a micrometre.
void CheckAgainstMesh(const Solid& solid, Random& random, double tolerance) {
  for (int i = 0; i < 50; ++i) {
    const Vector3d d = RandomDirection(random);
    double seen = -1e9;
    for (const Vector3d& p : solid.render_mesh.vertices) seen = std::max(seen, p.dot(d));
    const double exact = Support(solid.extent, d);
    CHECK(seen <= exact + 2e-6);
    CHECK(exact <= seen + tolerance);
  }
}

TEST_CASE("the hulls of prisms are those of their render meshes") {
  Random random(43);
  const std::vector<Vector2d> angle = {{0, 0}, {1, 0}, {1, .4}, {.4, .4}, {.4, 1}, {0, 1}};
  for (int i = 0; i < harness::Effort(30); ++i) {
    const Prism prism = {.polygon = angle,
                         .height = random.Uniform(0.5, 1),
                         .round = i % 3 == 0 ? 0 : random.Uniform(0.05, 0.2),
                         .bevel = i % 3 == 1 ? 0 : random.Uniform(0.01, 0.05)};
    CAPTURE(i, prism.round, prism.bevel);
    CheckAgainstMesh(Made(prism), random, 0.005);
  }
}

TEST_CASE("the hulls of tubes are those of their render meshes") {
  Random random(44);
  for (int i = 0; i < harness::Effort(100); ++i) {
    Tube tube = {.bend = i % 3 == 1 ? 0.2 : 0, .smooth = i % 3 == 2, .closed = i % 2 == 0};
    for (int k = 0; k < 5; ++k) {
      const double turn = 2 * kPi * k / 5;
      tube.path.push_back(random.Uniform(0.8, 1.2) *
                          Vector3d(std::cos(turn), std::sin(turn), random.Uniform(0, 0.4)));
      tube.radii.push_back(tube.smooth ? 0.1 : random.Uniform(0.05, 0.15));
    }
    CAPTURE(i);
    CheckAgainstMesh(Made(tube), random, 0.01);
  }
}

// A ring: the circle of its path, and the radius of the tube further.
TEST_CASE("a ring of arcs reaches as far as a torus") {
  const Solid ring = Made(Tube{.path = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}},
                               .radii = {0.5, 0.5, 0.5, 0.5},
                               .bend = 2,
                               .closed = true});
  Random random(45);
  for (int i = 0; i < 300; ++i) {
    const Vector3d d = RandomDirection(random);
    CHECK(Support(ring.extent, d) == Approx(2 * d.head<2>().norm() + 0.5).epsilon(1e-12));
  }
}

TEST_CASE("a smooth tube through points of a circle is nearly a torus") {
  Tube tube = {.smooth = true, .closed = true};
  for (int k = 0; k < 8; ++k) {
    tube.path.emplace_back(std::cos(2 * kPi * k / 8), std::sin(2 * kPi * k / 8), 0);
    tube.radii.push_back(0.1);
  }
  const Solid ring = Made(tube);
  CHECK(Support(ring.extent, {0, 0, 1}) == Approx(0.1).epsilon(1e-9));
  CHECK(Support(ring.extent, {1, 0, 0}) == Approx(1.1).epsilon(1e-9));
  CHECK(Support(ring.extent, {std::cos(kPi / 8), std::sin(kPi / 8), 0}) ==
        Approx(1.1).epsilon(0.01));
}

}  // namespace
}  // namespace mjforge::solid
