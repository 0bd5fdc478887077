// Tests of hulls, rounded boxes and cylinders, and tubes against closed forms, quadrature and
// meshes.

#include <sys/resource.h>

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include "harness/effort.h"
#include "harness/standard_error.h"
#include "reference_geometry.h"

namespace mjforge::solid {
namespace {

/// Sums of moments over weighted points; `Finished` returns the mass properties.
struct Sum {
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();

  void Add(const Vector3d& p, double weight) {
    volume += weight;
    first += weight * p;
    second += weight * p * p.transpose();
  }
  Mass Finished() const {
    Mass mass;
    mass.volume = volume;
    mass.center = first / volume;
    const Matrix3d about = second - volume * mass.center * mass.center.transpose();
    mass.inertia = about.trace() * Matrix3d::Identity() - about;
    return mass;
  }
};

std::vector<Vector3d> RandomPoints(Random& random) {
  std::vector<Vector3d> points;
  for (int i = 4 + random.Integer(17); i > 0; --i)
    points.emplace_back(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  return points;
}

TEST_CASE("a hull has the mass of what its triangles enclose, and all points in it") {
  Random random(31);
  for (int i = 0; i < harness::Effort(500); ++i) {
    CAPTURE(i);
    const ConvexHull hull = {.points = RandomPoints(random),
                             .texture = {.unit = TextureMapping::Unit::kNone}};
    const Solid solid = Made(hull);
    REQUIRE(solid.pieces.size() == 1);
    const ConvexPiece& piece = solid.pieces[0];
    CHECK(Difference(solid.mass, Enclosed(piece.mesh)) < 1e-9);
    for (const Vector3d& p : hull.points)
      CHECK(Contains(piece, p * (1 - 1e-9) + 1e-9 * solid.mass.center));
  }
}

// Rounding differs between processors, and between poses.
TEST_CASE("the order of a hull's faces and vertices does not depend on rounding") {
  Random random(37);
  ConvexHull box = {.points = {}, .texture = {.unit = TextureMapping::Unit::kNone}};
  for (const double x : {-3, 3})
    for (const double y : {-2, 2})
      for (const double z : {-1, 1}) box.points.emplace_back(x, y, z);
  const TriangleMesh mesh = Made(box).pieces[0].mesh;
  for (int i = 0; i < harness::Effort(100); ++i) {
    CAPTURE(i);
    const Matrix3d turn =
        Eigen::Quaterniond(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), 1)
            .normalized()
            .toRotationMatrix();
    ConvexHull turned = box;
    for (Vector3d& p : turned.points) p = turn * p;
    const TriangleMesh turned_mesh = Made(turned).pieces[0].mesh;
    CHECK(turned_mesh.triangles == mesh.triangles);
    REQUIRE(turned_mesh.vertices.size() == mesh.vertices.size());
    for (std::size_t j = 0; j < mesh.vertices.size(); ++j)
      CHECK((turned_mesh.vertices[j] - turn * mesh.vertices[j]).norm() < 1e-9);
  }
}

// The mesh checks all moments; its error is proportional to the square of its segments' length.
// Steiner's formula would need the mean width.
TEST_CASE("a rounded hull's mass is that of its surface, up to the surface's steps") {
  Random random(32);
  for (int i = 0; i < harness::Effort(20); ++i) {
    CAPTURE(i);
    const ConvexHull hull = {.points = RandomPoints(random), .round = random.Uniform(0.1, 1)};
    const Solid solid = Made(hull);
    const Mass seen = Enclosed(solid.render_mesh);
    CHECK(seen.volume < solid.mass.volume);
    CHECK(Difference(solid.mass, seen) < 0.1);
    const Mass collides = Enclosed(solid.pieces[0].mesh);
    CHECK(collides.volume < seen.volume);
  }
}

TEST_CASE("a hull that is turned and moved has the same mass, turned and moved") {
  Random random(33);
  for (int i = 0; i < harness::Effort(100); ++i) {
    ConvexHull hull = {.points = RandomPoints(random), .round = random.Uniform(0.01, 1)};
    const Mass mass = Made(hull).mass;
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), 1)
            .normalized();
    const Vector3d way(random.Uniform(-9, 9), random.Uniform(-9, 9), random.Uniform(-9, 9));
    for (Vector3d& p : hull.points) p = turn * p + way;
    const Matrix3d R = turn.toRotationMatrix();
    const Mass turned = {mass.volume, turn * mass.center + way, R * mass.inertia * R.transpose()};
    CHECK(Difference(Made(hull).mass, turned) < 1e-9);
  }
}

TEST_CASE("a rounded box has the mass of its core, slabs, quarters of cylinders and a ball") {
  Random random(34);
  for (int i = 0; i < harness::Effort(1000); ++i) {
    const Vector3d half(random.Uniform(0.1, 1), random.Uniform(0.1, 1), random.Uniform(0.1, 1));
    const double r = random.Uniform(0.01, 0.95) * half.minCoeff();
    const Vector3d c = half.array() - r;
    // Slices across z are rectangles whose corners are rounded with s.
    Sum sum;
    const auto slice = [&](double z, double s, double dz) {
      static const auto nodes = Gauss(12);
      // A quarter of the slice: the rectangle, two strips and a quarter of a disc.
      const double area = c.x() * c.y() + (c.x() + c.y()) * s + kPi / 4 * s * s;
      double xx = c.x() * c.x() * c.x() / 3 * (c.y() + s);
      double yy = c.y() * c.y() * c.y() / 3 * (c.x() + s);
      for (const auto& [a, wa] : nodes) {
        for (const auto& [b, wb] : nodes) {
          // Strips beside the rectangle, then the corner.
          xx += wa * wb * s * c.y() * std::pow(c.x() + a * s, 2);
          yy += wa * wb * s * c.x() * std::pow(c.y() + a * s, 2);
          const double angle = b * kPi / 2;
          const double weight = wa * wb * kPi / 2 * a * s * s;
          xx += weight * std::pow(c.x() + a * s * std::cos(angle), 2);
          yy += weight * std::pow(c.y() + a * s * std::sin(angle), 2);
        }
      }
      sum.volume += 4 * area * dz;
      sum.second(0, 0) += 4 * xx * dz;
      sum.second(1, 1) += 4 * yy * dz;
      sum.second(2, 2) += 4 * area * z * z * dz;
    };
    for (const auto& [share, weight] : Gauss(16)) {
      for (const double side : {-1.0, 1.0}) {
        slice(side * share * c.z(), r, weight * c.z());
        const double turn = share * kPi / 2;
        slice(side * (c.z() + r * std::sin(turn)), r * std::cos(turn),
              weight * kPi / 2 * r * std::cos(turn));
      }
    }
    const Solid solid = Made(RoundedBox{.half = half, .round = r});
    CHECK(Difference(solid.mass, sum.Finished()) < 1e-9);
    for (const Vector3d& p : solid.render_mesh.vertices)
      CHECK((p.cwiseAbs() - half).maxCoeff() < 1e-5);
    const auto plain = Made(RoundedBox{.half = half, .round = r, .piece_is_plain = true});
    CHECK(plain.pieces[0].type == ConvexPiece::Type::kBox);
    CHECK(plain.pieces[0].size == half);
  }
}

TEST_CASE("a rounded cylinder has the mass of its rings") {
  Random random(35);
  for (int i = 0; i < harness::Effort(300); ++i) {
    const double R = random.Uniform(0.1, 1);
    const double h = random.Uniform(0.1, 1);
    const double r = random.Uniform(0.01, 0.95) * std::min(R, h);
    Sum sum;
    const auto disc = [&](double z, double radius, double dz) {
      const double area = kPi * radius * radius;
      sum.volume += area * dz;
      sum.second.diagonal() +=
          dz * area * Vector3d(radius * radius / 4, radius * radius / 4, z * z);
    };
    for (const auto& [share, weight] : Gauss(20)) {
      for (const double side : {-1.0, 1.0}) {
        disc(side * share * (h - r), R, weight * (h - r));
        const double turn = share * kPi / 2;
        disc(side * (h - r + r * std::sin(turn)), R - r + r * std::cos(turn),
             weight * kPi / 2 * r * std::cos(turn));
      }
    }
    const RoundedCylinder cylinder = {.radius = R, .half = h, .round = r};
    const Solid solid = Made(cylinder);
    CHECK(Difference(solid.mass, sum.Finished()) < 1e-9);
    REQUIRE(solid.pieces.size() == 1);
    CHECK(VolumeOf(solid.pieces[0].mesh) < solid.mass.volume);
  }
}

// Quadrature over two lines and the arc between them, in coordinates about the path.
TEST_CASE("a bent tube has the mass of quadrature around its line") {
  Random random(36);
  for (int i = 0; i < harness::Effort(200); ++i) {
    CAPTURE(i);
    const double r = random.Uniform(0.01, 0.05);
    const double bend = random.Uniform(1.01, 5) * r;
    const double turn = random.Uniform(0.1, 2.5);
    const double a = bend * std::tan(turn / 2) + random.Uniform(0.01, 0.3);
    const double b = bend * std::tan(turn / 2) + random.Uniform(0.01, 0.3);
    const double less = random.Integer(2) * random.Uniform(0.2, 0.8) * r;
    const Vector3d out(std::cos(turn), std::sin(turn), 0);
    Tube tube = {.path = {{-a, 0, 0}, {0, 0, 0}, b * out}, .radii = {r, r, r}, .bend = bend};
    if (less > 0) tube.wall = r - less;
    const double taken = bend * std::tan(turn / 2);
    const Vector3d middle(-taken, bend, 0);
    Sum sum;
    const auto fill = [&](double radius, double sign) {
      for (const auto& [s, ws] : Gauss(14)) {
        for (const auto& [share, wr] : Gauss(6)) {
          for (int k = 0; k < 12; ++k) {
            const double angle = 2 * kPi * k / 12;
            const double up = share * radius * std::sin(angle);
            const double in = share * radius * std::cos(angle);
            const double disc = sign * ws * wr * radius * share * radius * 2 * kPi / 12;
            sum.Add({-a + s * (a - taken), in, up}, disc * (a - taken));
            const Vector3d left(-out.y(), out.x(), 0);
            sum.Add((taken + s * (b - taken)) * out + in * left + Vector3d(0, 0, up),
                    disc * (b - taken));
            const double at = s * turn;
            const double far = bend - in;
            sum.Add(middle + Vector3d(far * std::sin(at), -far * std::cos(at), up),
                    disc * turn * far);
          }
        }
      }
    };
    fill(r, 1);
    if (less > 0) fill(less, -1);
    CHECK(Difference(Made(tube).mass, sum.Finished()) < 1e-9);
  }
}

TEST_CASE("tubes with corners, cones and rings have the mass of closed forms") {
  // A corner is cut at half its angle: its two halves, one of them flipped, are a straight tube.
  const Mass corner =
      Made(Tube{.path = {{-2, 0, 0}, {0, 0, 0}, {0, 3, 0}}, .radii = {0.5, 0.5, 0.5}}).mass;
  CHECK(corner.volume == Approx(kPi * 0.25 * 5).epsilon(1e-12));
  const Solid solid =
      Made(Tube{.path = {{-2, 0, 0}, {0, 0, 0}, {0, 3, 0}}, .radii = {0.5, 0.5, 0.5}});
  CHECK(Difference(Enclosed(solid.render_mesh), corner) < 0.03);
  const Mass cone = Made(Tube{.path = {{0, 0, 0}, {0, 0, 3}}, .radii = {1, 2}}).mass;
  CHECK(cone.volume == Approx(kPi * (1 + 2 + 4)).epsilon(1e-12));
  CHECK(cone.center.z() == Approx(3.0 / 4 * (1 + 4 + 12) / 7).epsilon(1e-12));
  // A ring of four arcs.
  const Solid ring = Made(Tube{.path = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}},
                               .radii = {0.5, 0.5, 0.5, 0.5},
                               .bend = 2,
                               .closed = true});
  const double volume = 2 * kPi * kPi * 2 * 0.25;
  CHECK(ring.mass.volume == Approx(volume).epsilon(1e-12));
  CHECK(ring.mass.inertia(2, 2) == Approx(volume * (4 + 0.75 * 0.25)).epsilon(1e-12));
  CHECK(ring.mass.inertia(0, 0) == Approx(volume * (2 + 0.625 * 0.25)).epsilon(1e-12));
  CHECK(ring.pieces.size() == 16);
  for (const ConvexPiece& piece : ring.pieces) CHECK(piece.type == ConvexPiece::Type::kCapsule);
}

TEST_CASE("a smooth tube goes through its points, and its mass is that of its surface") {
  Random random(37);
  for (int i = 0; i < harness::Effort(30); ++i) {
    CAPTURE(i);
    Tube tube = {.smooth = true, .closed = random.Integer(2) == 0};
    for (int k = 0; k < 8; ++k) {
      const double turn = 2 * kPi * k / 8;
      tube.path.push_back(random.Uniform(0.8, 1.2) *
                          Vector3d(std::cos(turn), std::sin(turn), random.Uniform(0, 0.4)));
      tube.radii.push_back(random.Uniform(0.04, 0.06));
    }
    const Solid solid = Made(tube);
    CHECK(Difference(Enclosed(solid.render_mesh), solid.mass) < 0.03);
    // Skip the flat ends of an open tube.
    for (std::size_t k = 1; k + 1 < tube.path.size(); ++k)
      CHECK(ContainsAny(solid, 0.999 * tube.path[k]));
  }
}

template <typename Shape>
std::string FaultOf(const Shape& shape) {
  Fault fault;
  if (Make(shape, fault)) return "ok";
  return (fault.point ? fmt::format("{}: ", *fault.point) : "") + fault.message;
}

TEST_CASE("round things that cannot be are told why, at the point") {
  const auto tube = [](std::vector<Vector3d> path, double radius) {
    const std::vector<double> radii(path.size(), radius);
    return Tube{.path = std::move(path), .radii = radii};
  };
  CHECK(FaultOf(tube({{0, 0, 0}}, 1)) == "needs at least 2 points");
  CHECK(FaultOf(tube({{0, 0, 0}, {0, 0, 0}}, 1)) ==
        "1: is at the same place as the point before it");
  CHECK(FaultOf(tube({{0, 0, 0}, {9, 0, 0}, {3, 0, 0}}, 1)) ==
        "1: turns back on the line before it");
  CHECK(FaultOf(tube({{0, 0, 0}, {9, 0, 0}}, 0)) == "0: has a radius of 0 m");
  CHECK(FaultOf(tube({{0, 0, 0}, {9, 0, 0}, {9, 0.5, 0}}, 1)) ==
        "1: begins a line of 0.5 m, too short for its corners, which take 1 m");
  Tube bent = tube({{0, 0, 0}, {9, 0, 0}, {9, 9, 0}}, 1);
  bent.bend = 0.5;
  CHECK(FaultOf(bent) == "1: bends with 0.5 m, less than its radius of 1 m");
  bent.bend = 10;
  CHECK(FaultOf(bent) == "0: begins a line of 9 m, too short for its corners, which take 10 m");
  bent.bend = 2;
  bent.wall = 1;
  CHECK(FaultOf(bent) == "0: has a radius of 1 m, no more than its wall of 1 m");
  Tube curve = tube({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 1);
  curve.smooth = true;
  CHECK(FaultOf(curve).find("less than the tube's of 1 m") != std::string::npos);
  CHECK(FaultOf(ConvexHull{.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}) ==
        "has no volume: all points lie in a plane");
  CHECK(FaultOf(ConvexHull{.points = {{0, 0, 0}}}) == "needs at least 4 points");
  CHECK(FaultOf(RoundedBox{.half = {1, 2, 3}, .round = 1}) ==
        "is rounded with 1 m, no less than its smallest half size of 1 m");
}

TEST_CASE("Qhull prints nothing, even if no file can be opened") {
  struct rlimit limit;
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &limit) == 0);
  const ConvexHull flat = {.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
  const std::string printed = harness::StandardErrorOf([&] {
    const struct rlimit none = {0, limit.rlim_max};
    ::setrlimit(RLIMIT_NOFILE, &none);
    FaultOf(flat);
    ::setrlimit(RLIMIT_NOFILE, &limit);
  });
  CHECK(printed.empty());
}

}  // namespace
}  // namespace mjforge::solid
