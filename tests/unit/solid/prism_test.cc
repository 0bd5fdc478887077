// Tests of prisms with holes, rounded corners and bevels: mass against quadrature, pieces, faults.

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "reference_prism.h"

namespace mjforge::solid {
namespace {

/// Returns a star-shaped prism with up to three disjoint holes in its middle.
Prism RandomPrism(Random& random) {
  Prism prism;
  prism.polygon = RandomStar(random, {0.02, -0.01}, 0.06, 0.1, 5 + random.Integer(8));
  for (int i = random.Integer(4); i > 0; --i) {
    const Vector2d middle = Eigen::Rotation2Dd(2 * kPi * i / 3) * Vector2d(0.022, 0);
    prism.holes.push_back(
        RandomStar(random, middle + Vector2d(0.02, -0.01), 0.005, 0.015, 3 + random.Integer(6)));
  }
  prism.height = random.Uniform(0.01, 0.1);
  return prism;
}

/// Moments of polygons, by quadrature over signed triangles.
struct Sums {
  double area = 0;
  Vector2d first = Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void Add(const Vector2d& p, double weight) {
    area += weight;
    first += weight * p;
    second += weight * p * p.transpose();
  }
  void AddTriangle(const Vector2d& a, const Vector2d& b, const Vector2d& c, double sign) {
    static const auto nodes = Gauss(4);
    const Vector2d u = b - a;
    const Vector2d v = c - b;
    const double twice = sign * (u.x() * v.y() - u.y() * v.x());
    for (const auto& [s, ws] : nodes) {
      for (const auto& [t, wt] : nodes) Add(a + s * (u + t * v), twice * s * ws * wt);
    }
  }
  /// Adds a polygon given in either direction.
  void AddPolygon(const Points& polygon, double sign) {
    Sums own;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      own.AddTriangle(polygon[0], polygon[i], polygon[i + 1], 1);
    const double by = own.area < 0 ? -sign : sign;
    area += by * own.area;
    first += by * own.first;
    second += by * own.second;
  }
};

/// Adds the moments of a solid with these slices between two heights, by `count` quadrature nodes.
template <typename Slice>
void AddLayer(double below, double above, int count, const Slice& slice, Mass& sum) {
  for (const auto& [share, weight] : Gauss(count)) {
    const double z = below + share * (above - below);
    const Sums s = slice(z);
    const double dz = weight * (above - below);
    sum.volume += dz * s.area;
    sum.center += dz * Vector3d(s.first.x(), s.first.y(), z * s.area);
    Matrix3d second;
    second << s.second(0, 0), s.second(0, 1), z * s.first.x(),  //
        s.second(1, 0), s.second(1, 1), z * s.first.y(),        //
        z * s.first.x(), z * s.first.y(), z * z * s.area;
    sum.inertia += dz * second;
  }
}

/// Converts integrals of x and x x^T, stored as centre and inertia, to mass properties.
Mass Finished(Mass sum) {
  sum.center /= sum.volume;
  sum.inertia -= sum.volume * sum.center * sum.center.transpose();
  sum.inertia = (sum.inertia.trace() * Matrix3d::Identity() - sum.inertia).eval();
  return sum;
}

TEST_CASE("the mass of prisms with holes is that of quadrature") {
  Random random(21);
  for (int i = 0; i < harness::Effort(1000); ++i) {
    CAPTURE(i);
    const Prism prism = RandomPrism(random);
    Sums base;
    base.AddPolygon(prism.polygon, 1);
    for (const Points& hole : prism.holes) base.AddPolygon(hole, -1);
    Mass sum;
    AddLayer(
        -prism.height / 2, prism.height / 2, 2, [&](double) { return base; }, sum);
    CHECK(Difference(Made(prism).mass, Finished(sum)) < 1e-9);
  }
}

/// Returns the moments of all points within a distance of a convex polygon: the polygon, rectangles
/// on its sides, sectors at its corners.
Sums Around(const Points& core, double distance) {
  Sums sums;
  sums.AddPolygon(core, 1);
  const auto nodes = Gauss(16);
  const std::size_t count = core.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2d& a = core[i];
    const Vector2d& b = core[(i + 1) % count];
    const Vector2d side = (b - a).normalized();
    const Vector2d out(side.y(), -side.x());
    sums.AddPolygon({a, b, b + distance * out, a + distance * out}, 1);
    const Vector2d next = (core[(i + 2) % count] - b).normalized();
    const double from = std::atan2(out.y(), out.x());
    const double turn = std::atan2(side.x() * next.y() - side.y() * next.x(), side.dot(next));
    for (const auto& [share, wa] : nodes) {
      for (const auto& [r, wr] : nodes) {
        const double angle = from + share * turn;
        sums.Add(b + r * distance * Vector2d(std::cos(angle), std::sin(angle)),
                 wa * turn * wr * distance * r * distance);
      }
    }
  }
  return sums;
}

TEST_CASE("the mass of rounded and bevelled prisms is that of quadrature") {
  Random random(22);
  for (int i = 0; i < harness::Effort(200); ++i) {
    CAPTURE(i);
    const int count = 3 + random.Integer(7);
    Points core;
    for (int k = 0; k < count; ++k) {
      const double turn = 2 * kPi * (k + random.Uniform(-0.1, 0.1)) / count;
      core.push_back(0.05 * Vector2d(std::cos(turn), std::sin(turn)) + Vector2d(0.03, 0.01));
    }
    Prism prism;
    prism.round = random.Uniform(0.002, 0.01);
    prism.bevel = random.Integer(2) * random.Uniform(0.1, 0.9) * prism.round;
    prism.height = random.Uniform(0.03, 0.1);
    // Move each side of the core outwards by the radius.
    for (std::size_t k = 0; k < core.size(); ++k) {
      const Vector2d in = (core[k] - core[(k + core.size() - 1) % core.size()]).normalized();
      const Vector2d out = (core[(k + 1) % core.size()] - core[k]).normalized();
      const Vector2d a(in.y(), -in.x());
      const Vector2d b(out.y(), -out.x());
      prism.polygon.push_back(core[k] + prism.round * (a + b) / (1 + a.dot(b)));
    }
    const double top = prism.height / 2;
    const double edge = top - prism.bevel;
    const auto slice = [&](double z) {
      return Around(core, prism.round - std::max(0.0, std::abs(z) - edge));
    };
    Mass sum;
    AddLayer(-edge, edge, 2, slice, sum);
    if (prism.bevel > 0) {
      AddLayer(-top, -edge, 5, slice, sum);
      AddLayer(edge, top, 5, slice, sum);
    }
    const Solid solid = Made(prism);
    CHECK(Difference(solid.mass, Finished(sum)) < 1e-9);
    CHECK(solid.pieces.size() == 1);
  }
}

TEST_CASE("the pieces of a prism fill it, and nothing else") {
  Random random(23);
  for (int i = 0; i < harness::Effort(100); ++i) {
    CAPTURE(i);
    const Prism prism = RandomPrism(random);
    const Solid solid = Made(prism);
    double volume = 0;
    for (const ConvexPiece& piece : solid.pieces) {
      const double own = VolumeOf(piece.mesh);
      CHECK(own > 0);
      volume += own;
    }
    CHECK(volume == Approx(solid.mass.volume).epsilon(1e-9));
    CHECK(VolumeOf(solid.render_mesh) == Approx(solid.mass.volume).epsilon(1e-4));
    for (int k = 0; k < 300; ++k) {
      const Vector3d p(random.Uniform(-0.1, 0.14), random.Uniform(-0.13, 0.11),
                       random.Uniform(-0.06, 0.06));
      CHECK(ContainsAny(solid, p) == IsInside(prism, p));
    }
  }
}

TEST_CASE("the pieces of rounded and bevelled prisms stay in what is seen, and nearly fill it") {
  Random random(24);
  int seen = 0;
  int inside = 0;
  for (int i = 0; i < harness::Effort(60); ++i) {
    CAPTURE(i);
    Prism prism = RandomPrism(random);
    prism.round = random.Integer(2) * random.Uniform(0.001, 0.003);
    prism.bevel = prism.round > 0 ? prism.round * random.Uniform(0.2, 0.9) : 0.0005;
    Fault fault;
    const std::optional<Solid> solid = Make(prism, fault);
    if (!solid) continue;  // a side may be too short, a hole too near
    CHECK(VolumeOf(solid->render_mesh) == Approx(solid->mass.volume).epsilon(2e-3));
    for (int k = 0; k < 60; ++k) {
      const Vector3d p(random.Uniform(-0.06, 0.1), random.Uniform(-0.09, 0.07),
                       random.Uniform(-0.5, 0.5) * prism.height);
      if (ContainsAny(*solid, p)) {
        ++inside;
        CHECK(Encloses(solid->render_mesh, p));
      }
      seen += Encloses(solid->render_mesh, p) ? 1 : 0;
    }
  }
  CHECK(inside > harness::Effort(1000));
  CHECK(inside > 0.97 * seen);
}

TEST_CASE("prisms that cannot be are told why, at the point") {
  const Points square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto with = [&](Points hole) {
    return Prism{.polygon = square, .holes = {std::move(hole)}, .height = 1};
  };
  CHECK(PrismFault(with({{0.2, 0.2}, {0.8, 0.2}, {0.5, 0.8}})) == "ok");
  CHECK(PrismFault(with({{0.2, 0.2}, {1, 0.2}, {0.5, 0.8}})).starts_with("hole 1 "));
  CHECK(PrismFault(with({{2, 2}, {3, 2}, {3, 3}})) == "hole 1 is outside of the shape");
  CHECK(PrismFault(with({{0.2, 0.2}, {0.8, 0.8}, {0.8, 0.2}, {0.2, 0.8}})).starts_with("hole 1 "));
  Prism two = with({{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}});
  two.holes.push_back({{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}});
  CHECK(PrismFault(two) == "hole 2 and hole 1 lie in each other");
  two.holes[1] = {{0.05, 0.4}, {0.6, 0.4}, {0.5, 0.6}};
  CHECK(PrismFault(two) == "hole 2 1: begins a line that crosses or touches hole 1");
  CHECK(PrismFault({.polygon = square, .height = 1, .round = 0.5}) == "ok");
  CHECK(PrismFault({.polygon = square, .height = 1, .round = 0.6}) ==
        "0: leaves a side of 1 m, too short for corners of 0.6 m");
  CHECK(PrismFault({.polygon = square, .height = 1, .bevel = 0.5}) ==
        "is bevelled by 0.5 m, half its height of 1 m or more");
  CHECK(PrismFault({.polygon = square, .height = 2, .bevel = 0.6}) ==
        "0: begins a side of 1 m, too short for a bevel of 0.6 m");
  CHECK(PrismFault({.polygon = square, .height = 2, .round = 0.1, .bevel = 0.1}) ==
        "is bevelled by 0.1 m, no less than its corners are rounded with: 0.1 m");
}

}  // namespace
}  // namespace mjforge::solid
