// Tests of lathes: mass against quadrature, pieces against the exact solid, render mesh.

#include "mjforge/solid/solid.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "harness/effort.h"
#include "reference_geometry.h"

namespace mjforge::solid {
namespace {

/// Returns a star-shaped profile about a middle point: on the axis, so that the solid has no hole,
/// or away from the axis.
std::vector<Vector2d> RandomProfile(Random& random) {
  std::vector<Vector2d> profile;
  const bool on_axis = random.Integer(2) == 0;
  const int count = 3 + random.Integer(10);
  const Vector2d middle(on_axis ? 0 : random.Uniform(0.11, 0.3), random.Uniform(-0.2, 0.2));
  if (on_axis) profile.emplace_back(0, middle.y() - random.Uniform(0.01, 0.1));
  for (int i = 0; i < count; ++i) {
    const double turn = on_axis ? kPi * ((i + random.Uniform(0.2, 0.8)) / count - 0.5)
                                : 2 * kPi * (i + random.Uniform(0.2, 0.8)) / count;
    const double radius = random.Uniform(0.02, 0.1);
    profile.push_back(middle + radius * Vector2d(std::cos(turn), std::sin(turn)));
  }
  if (on_axis) profile.emplace_back(0, middle.y() + random.Uniform(0.01, 0.1));
  if (random.Integer(2) == 0) std::ranges::reverse(profile);
  return profile;
}

/// Returns the mass by quadrature over the signed triangles from a point to each edge, and over the
/// angle.
Mass Integrated(const std::vector<Vector2d>& profile, double angle) {
  const auto nodes = Gauss(4);  // exact for polynomials of degree 7
  const auto turns = Gauss(14);
  const Vector2d a = profile[0];
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
    const Vector2d u = profile[i] - a;
    const Vector2d v = profile[i + 1] - profile[i];
    const double twice = u.x() * v.y() - u.y() * v.x();
    for (const auto& [s, ws] : nodes) {
      for (const auto& [t, wt] : nodes) {
        const Vector2d p = a + s * (u + t * v);
        for (const auto& [share, wa] : turns) {
          const double weight = twice * s * ws * wt * wa * angle * p.x();
          const Vector3d q(p.x() * std::cos(share * angle), p.x() * std::sin(share * angle), p.y());
          volume += weight;
          first += weight * q;
          second += weight * q * q.transpose();
        }
      }
    }
  }
  Mass mass;
  mass.volume = std::abs(volume);
  mass.center = first / volume;
  second = second / volume * mass.volume - mass.volume * mass.center * mass.center.transpose();
  mass.inertia = second.trace() * Matrix3d::Identity() - second;
  return mass;
}

TEST_CASE("the mass of turned solids is that of quadrature") {
  Random random(1);
  for (int i = 0; i < harness::Effort(1000); ++i) {
    CAPTURE(i);
    Lathe lathe = {.profile = RandomProfile(random)};
    if (i % 2 == 1) lathe.angle = random.Uniform(0.1, 6);
    const Mass mass = Made(lathe).mass;
    const Mass expected = Integrated(lathe.profile, lathe.angle);
    CHECK(std::abs(mass.volume - expected.volume) <= 1e-9 * expected.volume);
    CHECK((mass.center - expected.center).norm() <= 1e-9 * 0.3);
    CHECK((mass.inertia - expected.inertia).norm() <= 1e-9 * expected.inertia.norm());
  }
}

TEST_CASE("a walled profile has the mass of the outline between it and its parallel") {
  const Lathe cup = {.profile = {{0, 0}, {0.04, 0}, {0.04, 0.1}}, .wall = 0.003};
  const double volume = kPi * (0.04 * 0.04 * 0.1 - 0.037 * 0.037 * 0.097);
  CHECK(Made(cup).mass.volume == Approx(volume).epsilon(1e-12));
  Lathe upside_down = cup;
  std::ranges::reverse(upside_down.profile);
  CHECK(Made(upside_down).mass.volume == Approx(volume).epsilon(1e-12));
  const Lathe pipe = {.profile = {{0.02, 0}, {0.02, 0.5}}, .wall = 0.002};
  CHECK(Made(pipe).mass.volume == Approx(kPi * 0.5 * (0.02 * 0.02 - 0.018 * 0.018)).epsilon(1e-12));
}

// The cross section of a facet at any angle is the profile, with r multiplied by a number. From the
// middle of the facet to its ends, this number grows by at most the factor 1 / cos(pi / facets).
TEST_CASE("pieces fill the solid up to the chord error, and never reach into a cavity") {
  Random random(2);
  int outside = 0;
  int inside = 0;
  for (int i = 0; i < harness::Effort(100); ++i) {
    CAPTURE(i);
    Lathe lathe = {.profile = RandomProfile(random), .facets = 3 + random.Integer(22)};
    if (i % 3 == 0) lathe.angle = random.Uniform(0.2, 6);
    const Solid solid = Made(lathe);
    const double least = std::cos(kPi / lathe.facets);
    const auto any_of = [&](double lo, double hi, double r, double z) {
      for (int k = 0; k <= 60; ++k) {
        if (Contains(lathe.profile, r * (lo + (hi - lo) * k / 60), z)) return true;
      }
      return false;
    };
    for (int k = 0; k < 100; ++k) {
      const double r = random.Uniform(0, 0.5);
      const double z = random.Uniform(-0.35, 0.35);
      const double turn = random.Uniform(0, lathe.angle);
      const bool hit = ContainsAny(solid, {r * std::cos(turn), r * std::sin(turn), z});
      CAPTURE(r, z, turn);
      if (hit) {
        ++inside;
        CHECK(any_of(least, 1, r, z));
      } else {
        ++outside;
        bool all = true;
        for (int step = 0; step <= 60 && all; ++step)
          all = Contains(lathe.profile, r * (least + (1 / least - least) * step / 60), z);
        CHECK_FALSE(all);
      }
    }
  }
  CHECK(inside > harness::Effort(100));
  CHECK(outside > harness::Effort(1000));
}

TEST_CASE("pieces are convex and closed, and their volumes add up") {
  Random random(3);
  for (int i = 0; i < harness::Effort(60); ++i) {
    CAPTURE(i);
    const Lathe lathe = {.profile = RandomProfile(random), .facets = 64};
    const Solid solid = Made(lathe);
    double sum = 0;
    for (const ConvexPiece& piece : solid.pieces) {
      const double volume = VolumeOf(piece.mesh);
      CHECK(volume > 0);
      sum += volume * static_cast<double>(piece.turns.size());
      // Convex: every vertex is on the inner side of every face.
      for (const std::array<int, 3>& t : piece.mesh.triangles) {
        const Vector3d& a = piece.mesh.vertices[std::size_t(t[0])];
        const Vector3d out = (piece.mesh.vertices[std::size_t(t[1])] - a)
                                 .cross(piece.mesh.vertices[std::size_t(t[2])] - a);
        double farthest = 0;
        for (const Vector3d& p : piece.mesh.vertices) farthest = std::max(farthest, out.dot(p - a));
        CHECK(farthest <= 1e-12 * out.norm());
      }
    }
    CHECK(sum == Approx(solid.mass.volume).epsilon(0.02));
  }
}

TEST_CASE("what is seen is closed, faces outwards, and nears the solid") {
  Random random(4);
  for (int i = 0; i < harness::Effort(60); ++i) {
    CAPTURE(i);
    Lathe lathe = {.profile = RandomProfile(random)};
    if (i % 3 == 0) lathe.angle = random.Uniform(0.2, 6);
    const Solid solid = Made(lathe);
    const TriangleMesh& mesh = solid.render_mesh;
    CHECK(VolumeOf(mesh) == Approx(solid.mass.volume).epsilon(0.01));
    REQUIRE(mesh.normals.size() == mesh.vertices.size());
    REQUIRE(mesh.texcoords.size() == mesh.vertices.size());
    for (const Vector3d& normal : mesh.normals) CHECK(normal.norm() == Approx(1).margin(2e-4));
    for (const std::array<int, 3>& t : mesh.triangles) {
      const Vector3d& a = mesh.vertices[std::size_t(t[0])];
      const Vector3d out =
          (mesh.vertices[std::size_t(t[1])] - a).cross(mesh.vertices[std::size_t(t[2])] - a);
      if (out.norm() < 1e-9) continue;  // a triangle without area at the axis
      for (const int corner : t) CHECK(out.dot(mesh.normals[std::size_t(corner)]) > 0);
    }
  }
}

TEST_CASE("edges are sharp where they turn by more than the crease") {
  const auto normals_at_edge = [](double crease) {
    const Solid cone =
        Made(Lathe{.profile = {{0, 0}, {0.05, 0}, {0.04, 0.05}, {0, 0.05}}, .crease = crease});
    std::vector<Vector3d> normals;
    for (std::size_t i = 0; i < cone.render_mesh.vertices.size(); ++i) {
      if ((cone.render_mesh.vertices[i] - Vector3d(0.05, 0, 0)).norm() < 1e-9)
        normals.push_back(cone.render_mesh.normals[i]);
    }
    return normals;
  };
  // Two normals (bottom and side), each at both ends of the texture.
  CHECK(normals_at_edge(1).size() == 4);
  CHECK(normals_at_edge(3).size() == 2);
}

TEST_CASE("a label goes once around, and up along the profile") {
  Lathe can = {.profile = {{0, 0}, {0.03, 0}, {0.03, 0.1}}, .wall = 0.001};
  const auto at = [](const Solid& solid, const Vector3d& p) {
    for (std::size_t i = 0; i < solid.render_mesh.vertices.size(); ++i) {
      if ((solid.render_mesh.vertices[i] - p).norm() < 1e-6) return solid.render_mesh.texcoords[i];
    }
    return Vector2d(-1, -1);
  };
  CHECK((at(Made(can), {0.03, 0, 0.1}) - Vector2d(0, 0)).norm() < 1e-4);
  CHECK((at(Made(can), {0, 0.03, 0}) - Vector2d(0.25, 10.0 / 13)).norm() < 1e-4);
  can.texture.unit = TextureMapping::Unit::kNone;
  CHECK(Made(can).render_mesh.texcoords.empty());
  can.texture = {TextureMapping::Unit::kMetre, {2, 3}};
  CHECK((at(Made(can), {0, 0.03, 0.1}) - Vector2d(0.03 * kPi, 0)).norm() < 1e-4);
}

TEST_CASE("a convex solid around the axis is one piece, a wall one for each facet") {
  const auto counts = [](const Lathe& lathe) {
    std::vector<std::size_t> turns;
    for (const ConvexPiece& piece : Made(lathe).pieces) turns.push_back(piece.turns.size());
    std::ranges::sort(turns);
    return turns;
  };
  using Counts = std::vector<std::size_t>;
  CHECK(counts({.profile = {{0, 0}, {0.05, 0}, {0.04, 0.05}, {0, 0.08}}}) == Counts{1});
  CHECK(counts({.profile = {{0, 0}, {0.05, 0}, {0.05, 0.1}}, .wall = 0.002}) == Counts{1, 16});
  CHECK(counts({.profile = {{0.02, 0}, {0.05, 0}, {0.05, 0.1}}, .facets = 10}) == Counts{10});
  CHECK(counts({.profile = {{0, 0}, {0.05, 0}, {0, 0.1}}, .angle = kPi / 2}) == Counts{4});
}

}  // namespace
}  // namespace mjforge::solid
