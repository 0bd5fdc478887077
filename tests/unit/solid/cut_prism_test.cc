// Tests of prisms with holes along several axes: mass against sums of boxes and sampling, pieces,
// render meshes, faults.

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "reference_prism.h"

namespace mjforge::solid {
namespace {

Points Rectangle(double u0, double u1, double v0, double v1) {
  return {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
}

/// Returns a star-shaped prism with up to one hole along z and some along x and y, which may meet.
Prism RandomCutPrism(Random& random) {
  Prism prism;
  prism.polygon = RandomStar(random, {0.02, -0.01}, 0.06, 0.1, 5 + random.Integer(6));
  prism.height = random.Uniform(0.1, 0.15);
  if (random.Integer(2) == 0)
    prism.holes.push_back(RandomStar(random, {0.02, -0.01}, 0.005, 0.02, 3 + random.Integer(4)));
  for (int i = 0; i < 1 + random.Integer(2); ++i)
    prism.holes_x.push_back(
        RandomStar(random, {-0.01, 0.04 * i - 0.02}, 0.005, 0.017, 3 + random.Integer(5)));
  for (int i = 0; i < random.Integer(3); ++i)
    prism.holes_y.push_back(
        RandomStar(random, {0.02, 0.04 * i - 0.02}, 0.005, 0.017, 3 + random.Integer(5)));
  return prism;
}

/// Signed sum of boxes, each given by its lowest and highest corner.
class BoxSum {
 public:
  void Add(const Vector3d& low, const Vector3d& high, double sign) {
    const Vector3d size = high - low;
    const Vector3d center = (low + high) / 2;
    const double volume = sign * size.prod();
    volume_ += volume;
    first_ += volume * center;
    second_ += volume * center * center.transpose();
    second_ += volume / 12 * Matrix3d(size.cwiseAbs2().asDiagonal());
  }
  Mass Total() const {
    Mass mass{.volume = volume_, .center = first_ / volume_};
    const Matrix3d about = second_ - volume_ * mass.center * mass.center.transpose();
    mass.inertia = about.trace() * Matrix3d::Identity() - about;
    return mass;
  }

 private:
  double volume_ = 0;
  Vector3d first_ = Vector3d::Zero();
  Matrix3d second_ = Matrix3d::Zero();
};

TEST_CASE("a box with windows along x, y and z has the mass of boxes added and subtracted") {
  Prism prism{.polygon = Rectangle(-0.1, 0.1, -0.06, 0.06), .height = 0.08};
  prism.holes = {Rectangle(0.06, 0.08, -0.02, 0.03)};
  prism.holes_x = {Rectangle(-0.03, 0.01, -0.02, 0.02)};
  prism.holes_y = {Rectangle(-0.05, 0.02, -0.02, 0.03)};
  BoxSum sum;
  sum.Add({-0.1, -0.06, -0.04}, {0.1, 0.06, 0.04}, 1);
  sum.Add({0.06, -0.02, -0.04}, {0.08, 0.03, 0.04}, -1);
  sum.Add({-0.1, -0.03, -0.02}, {0.1, 0.01, 0.02}, -1);
  sum.Add({-0.05, -0.06, -0.02}, {0.02, 0.06, 0.03}, -1);
  sum.Add({0.06, -0.02, -0.02}, {0.08, 0.01, 0.02}, 1);   // along z and x
  sum.Add({-0.05, -0.03, -0.02}, {0.02, 0.01, 0.02}, 1);  // along x and y
  const Solid solid = Made(prism);
  CHECK(Difference(solid.mass, sum.Total()) < 1e-12);
  // The floors of both windows are in one plane, which the mesh has only once.
  CHECK(Difference(Enclosed(solid.render_mesh), sum.Total()) < 1e-9);
  CHECK(std::ranges::all_of(solid.pieces, [](const ConvexPiece& piece) {
    return piece.type == ConvexPiece::Type::kBox;
  }));
}

TEST_CASE("pieces that are convex together are one") {
  Prism prism{.polygon = Rectangle(-0.1, 0.1, -0.06, 0.06), .height = 0.08};
  prism.holes_x = {Rectangle(-0.03, 0.03, -0.02, 0.02)};
  CHECK(Made(prism).pieces.size() == 4);
  prism.holes_y = {Rectangle(-0.05, 0.05, -0.02, 0.02)};
  CHECK(Made(prism).pieces.size() == 6);  // floor, ceiling and four posts
}

TEST_CASE("a wall in the plane of a hole's side is seen once, on the side of the solid") {
  // The step of an L at y = 0.02 is in the plane of sides of both holes.
  Prism prism{.polygon = {{0, 0}, {0.1, 0}, {0.1, 0.02}, {0.05, 0.02}, {0.05, 0.06}, {0, 0.06}},
              .height = 0.08};
  BoxSum sum;
  sum.Add({0, 0, -0.04}, {0.1, 0.02, 0.04}, 1);
  sum.Add({0, 0.02, -0.04}, {0.05, 0.06, 0.04}, 1);
  prism.holes_x = {Rectangle(0.01, 0.02, -0.03, -0.01), Rectangle(0.02, 0.03, 0.01, 0.03)};
  sum.Add({0, 0.01, -0.03}, {0.1, 0.02, -0.01}, -1);
  sum.Add({0, 0.02, 0.01}, {0.05, 0.03, 0.03}, -1);
  const Solid solid = Made(prism);
  CHECK(Difference(solid.mass, sum.Total()) < 1e-12);
  CHECK(Difference(Enclosed(solid.render_mesh), sum.Total()) < 1e-9);
}

TEST_CASE("pieces, render mesh and mass of prisms cut along several axes are the same solid") {
  Random random(25);
  for (int i = 0; i < harness::Effort(100); ++i) {
    CAPTURE(i);
    const Prism prism = RandomCutPrism(random);
    const Solid solid = Made(prism);
    double volume = 0;
    for (const ConvexPiece& piece : solid.pieces) {
      const double own =
          piece.type == ConvexPiece::Type::kBox ? 8 * piece.size.prod() : VolumeOf(piece.mesh);
      CHECK(own > 0);
      volume += own;
    }
    CHECK(volume == Approx(solid.mass.volume).epsilon(1e-9));
    // The render mesh does not depend on the pieces; its vertices are rounded to a micrometre.
    CHECK(Difference(Enclosed(solid.render_mesh), solid.mass) < 1e-4);
    int inside = 0;
    const int count = 400;
    for (int k = 0; k < count; ++k) {
      const Vector3d p(random.Uniform(-0.08, 0.12), random.Uniform(-0.11, 0.09),
                       random.Uniform(-0.5, 0.5) * prism.height);
      CHECK(ContainsAny(solid, p) == IsInside(prism, p));
      inside += IsInside(prism, p) ? 1 : 0;
    }
    const double share = double(inside) / count;
    const double sampled = share * 0.2 * 0.2 * prism.height;
    const double deviation = std::sqrt(share * (1 - share) / count) / share;
    CHECK(solid.mass.volume == Approx(sampled).epsilon(4 * deviation));
  }
}

TEST_CASE("the mass of a prism cut along several axes is that of a fine grid") {
  Random random(26);
  const Prism prism = RandomCutPrism(random);
  const int count = 80;
  BoxSum sum;
  const Vector3d low(-0.08, -0.11, -prism.height / 2);
  const Vector3d step = Vector3d(0.2, 0.2, prism.height) / count;
  for (int i = 0; i < count * count * count; ++i) {
    const Vector3d corner =
        low + step.cwiseProduct(Vector3d(i % count, i / count % count, i / count / count));
    if (IsInside(prism, corner + step / 2)) sum.Add(corner, corner + step, 1);
  }
  CHECK(Difference(Made(prism).mass, sum.Total()) < 5e-3);
}

TEST_CASE("a hole along x is a hole along z of the prism that is turned") {
  Random random(27);
  for (int i = 0; i < harness::Effort(50); ++i) {
    CAPTURE(i);
    const Points hole = RandomStar(random, {0.01, 0.005}, 0.01, 0.03, 3 + random.Integer(9));
    const Mass z =
        Made(Prism{.polygon = Rectangle(-0.05, 0.05, -0.04, 0.04), .holes = {hole}, .height = 0.1})
            .mass;
    const Mass x =
        Made(Prism{
                 .polygon = Rectangle(-0.05, 0.05, -0.05, 0.05), .holes_x = {hole}, .height = 0.08})
            .mass;
    Matrix3d turn;  // x y z of the first are y z x of the second
    turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    const Mass turned{z.volume, turn * z.center, turn * z.inertia * turn.transpose()};
    CHECK(Difference(x, turned) < 1e-9);
  }
}

TEST_CASE("holes along x and y that cannot be are told why") {
  const Points square = Rectangle(0, 1, 0, 1);
  Prism prism{.polygon = square, .height = 1};
  prism.holes = {Rectangle(0.1, 0.2, 0.1, 0.2)};
  prism.holes_x = {Rectangle(0.3, 0.7, -0.2, 0.2)};
  prism.holes_y = {Rectangle(0.2, 0.8, 0.3, 0.4)};
  CHECK(PrismFault(prism) == "ok");
  Prism bad = prism;
  bad.holes_x = {Rectangle(0.3, 0.7, -0.2, 0.5)};
  CHECK(PrismFault(bad) == "hole 2 3: begins a line that crosses or touches the edge of the shape");
  bad.holes_x = {Rectangle(2, 3, 0, 0.1)};
  CHECK(PrismFault(bad) == "hole 2 is outside of the shape");
  bad = prism;
  bad.holes_y.push_back(Rectangle(0.3, 0.4, 0.35, 0.45));
  CHECK(PrismFault(bad) == "hole 4 2: begins a line that crosses or touches hole 1 along y");
  bad.holes_y[1] = Rectangle(0.3, 0.4, 0.32, 0.35);
  CHECK(PrismFault(bad) == "hole 4 and hole 1 along y lie in each other");
  bad.holes_y[1] = {{0, 0}, {0.1, 0}, {0.2, 0}};
  CHECK(PrismFault(bad) == "hole 4 has no area");
  bad = prism;
  bad.round = 0.1;
  CHECK(PrismFault(bad) == "has holes along x or y, so that it cannot be rounded or bevelled");
}

TEST_CASE("holes that cut the solid in two are a fault") {
  // A plate with a tongue. The holes along x are wider than the tongue.
  Prism prism{.polygon = {{0, 0}, {1, 0}, {1, 0.4}, {2, 0.4}, {2, 0.6}, {1, 0.6}, {1, 1}, {0, 1}},
              .height = 1};
  prism.holes_x = {Rectangle(0.3, 0.7, 0.2, 0.4), Rectangle(0.3, 0.7, -0.4, -0.2)};
  CHECK(PrismFault(prism) == "ok");
  prism.holes_y = {Rectangle(1.1, 1.3, -0.19, 0.3)};
  CHECK(PrismFault(prism) == "ok");
  prism.holes_y = {Rectangle(1.1, 1.3, -0.3, 0.3)};
  CHECK(PrismFault(prism) == "falls apart: its holes cut it into 2 parts");
  // Each wall of the loose block is inside of the box's faces.
  Prism box{.polygon = Rectangle(-1, 1, -1, 1), .height = 2};
  box.holes = {Rectangle(-0.95, 0.95, -0.95, -0.85), Rectangle(-0.95, 0.95, 0.85, 0.95)};
  box.holes_x = {Rectangle(-0.9, 0.9, -0.5, -0.3), Rectangle(-0.9, 0.9, 0.3, 0.5)};
  box.holes_y = {Rectangle(-0.99, -0.9, -0.5, 0.5)};
  CHECK(PrismFault(box) == "ok");
  box.holes_y.push_back(Rectangle(0.9, 0.99, -0.5, 0.5));
  CHECK(PrismFault(box) == "falls apart: its holes cut it into 2 parts");
}

TEST_CASE("holes that need too many pieces are a fault") {
  const auto grid = [](double least) {
    std::vector<Points> holes;
    for (int i = 0; i < 9; ++i) {
      for (int k = 0; k < 9; ++k) {
        const double u = least + 0.1 * i;
        const double v = -0.45 + 0.1 * k;
        holes.push_back({{u, v}, {u + 0.03, v + 0.02}, {u, v + 0.05}});
      }
    }
    return holes;
  };
  Prism prism{.polygon = Rectangle(0, 1, 0, 1), .height = 1};
  prism.holes_x = grid(0.05);
  CHECK(PrismFault(prism) == "ok");
  prism.holes_y = grid(0.07);
  CHECK(PrismFault(prism) == "is cut into more than 1000 convex pieces by its holes");
}

}  // namespace
}  // namespace mjforge::solid
