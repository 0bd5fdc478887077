// What is seen of shapes: how round it is, its normals, how pictures are laid on.

#include <catch2/catch.hpp>

#include <map>
#include <set>

#include "measured.h"

namespace mjforge::solid {
namespace {

template <typename Shape>
Surface Seen(const Shape& shape) {
  Fault fault;
  std::optional<Solid> solid = Make(shape, fault);
  INFO(fault.message);
  REQUIRE(solid);
  return std::move(solid->look);
}

const Texture kNone = {.unit = Texture::Unit::kNone};

Surface Can(double radius, double height, double angle = 2 * kPi) {
  return Seen(Lathe{.profile = {{0, 0}, {radius, 0}, {radius, height}, {0, height}},
                    .angle = angle,
                    .texture = kNone});
}

/// The largest distance from the z axis to a line of triangles at the radius.
double ChordError(const Surface& look, double radius) {
  const auto distance = [&](const Vector3d& p) { return radius - p.head<2>().norm(); };
  double error = 0;
  for (const std::array<int, 3>& t : look.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d& a = look.vertices[std::size_t(t[std::size_t(i)])];
      const Vector3d& b = look.vertices[std::size_t(t[std::size_t((i + 1) % 3)])];
      if (std::max(distance(a), distance(b)) < 2e-6) error = std::max(error, distance((a + b) / 2));
    }
  }
  return error;
}

std::size_t RimCount(const Surface& look, double radius) {
  std::set<std::pair<double, double>> places;
  for (const Vector3d& p : look.vertices) {
    if (p.head<2>().norm() > radius - 2e-6) places.emplace(p.x(), p.y());
  }
  return places.size();
}

/// Normals of the triangles at each vertex, weighted by area, as MuJoCo makes them.
std::vector<Vector3d> Computed(const Surface& look) {
  std::vector<Vector3d> normals(look.vertices.size(), Vector3d::Zero());
  for (const std::array<int, 3>& t : look.triangles) {
    const auto at = [&](int i) { return look.vertices[std::size_t(t[std::size_t(i)])]; };
    for (const int corner : t) normals[std::size_t(corner)] += (at(1) - at(0)).cross(at(2) - at(0));
  }
  for (Vector3d& normal : normals) normal.normalize();
  return normals;
}

/// The largest angle between computed and true normals, deg.
double Lean(const Surface& look) {
  const std::vector<Vector3d> computed = Computed(look);
  double most = 0;
  for (std::size_t i = 0; i < computed.size(); ++i)
    most = std::max(most, std::acos(std::min(1.0, computed[i].dot(look.normals[i].normalized()))));
  return most * 180 / kPi;
}

TEST_CASE("chords are near the true circle, and no more than that takes") {
  for (const double radius : {0.003, 0.01, 0.03, 0.045, 0.1, 0.5}) {
    for (const double height : {0.001, 0.05, 0.2}) {
      CAPTURE(radius, height);
      const Surface look = Can(radius, height);
      const double half = std::max(radius, height / 2);
      const std::size_t count = RimCount(look, radius);
      CHECK((ChordError(look, radius) < std::min(0.25e-3, 0.005 * half) + 2e-6 || count == 48));
      CHECK(std::set<std::size_t>{16, 32, 48}.contains(count));
    }
  }
  CHECK(RimCount(Can(0.04, 0.1), 0.04) == 32);
  CHECK(RimCount(Can(0.004, 0.1), 0.004) == 16);
  // A small part of a large circle is as round.
  CHECK(RimCount(Can(2, 0.1, 0.2), 2) == 10);
  CHECK(ChordError(Can(2, 0.1, 0.2), 2) < 0.25e-3 + 2e-6);
}

TEST_CASE("without a texture each edge of a smooth surface is that of two triangles") {
  const Surface ring = Seen(Lathe{.profile = {{0.03, 0}, {0.04, 0}, {0.04, 0.01}, {0.03, 0.01}},
                                  .crease = kPi,
                                  .texture = kNone});
  const Surface wheel = Seen(Tube{.path = {{0, 0, 0}, {0.2, 0, 0}, {0.2, 0.2, 0}, {0, 0.2, 0}},
                                  .radii = {0.01, 0.01, 0.01, 0.01},
                                  .bend = 0.05,
                                  .closed = true,
                                  .texture = kNone});
  for (const Surface* look : {&ring, &wheel}) {
    std::map<std::pair<int, int>, int> edges;
    for (const std::array<int, 3>& t : look->triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
      CHECK(count == 1);
      CHECK(edges.contains({edge.second, edge.first}));
    }
    CHECK(look->texcoords.empty());
  }
}

TEST_CASE("normals that MuJoCo computes of the triangles hardly differ from the true ones") {
  Lathe vase = {.profile = {{0, 0}, {0.03, 0}}, .texture = kNone};
  for (int i = 1; i <= 12; ++i)
    vase.profile.emplace_back(0.03 + 0.01 * std::sin(i * 0.4), 0.01 * i);
  vase.profile.emplace_back(0, 0.12);
  CHECK(Lean(Seen(vase)) < 2);
  CHECK(Lean(Seen(Tube{.path = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}},
                       .radii = {0.01, 0.01, 0.01},
                       .bend = 0.03,
                       .texture = kNone})) < 5);
  CHECK(Lean(Seen(RoundedBox{.half = {0.05, 0.03, 0.02}, .round = 0.005, .texture = kNone})) < 16);
  CHECK(Lean(Seen(Prism{.polygon = {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}},
                        .height = 0.01,
                        .round = 0.02,
                        .texture = kNone})) < 8);
}

TEST_CASE("boxes and hulls get their picture from above, as MuJoCo's own boxes") {
  RoundedBox box = {.half = {0.05, 0.03, 0.02}, .round = 0.005, .texture = {.repeat = {2, 3}}};
  const auto check = [](const Surface& look, const Vector2d& scale) {
    REQUIRE(look.texcoords.size() == look.vertices.size());
    for (std::size_t i = 0; i < look.vertices.size(); ++i) {
      const Vector2d want = (look.vertices[i].head<2>().cwiseProduct(scale).array() + 0.5).matrix();
      CHECK((look.texcoords[i] - want).norm() < 5e-5);
    }
  };
  check(Seen(box), Vector2d(2 / 0.1, -3 / 0.06));
  box.texture.unit = Texture::Unit::kMetre;
  check(Seen(box), Vector2d(2, -3));
  Hull hull = {.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}};
  const Surface pyramid = Seen(hull);
  check(pyramid, Vector2d(0.5, -0.5));
  CHECK(pyramid.vertices.size() == 16);  // each face has its own
  CHECK(Lean(pyramid) < 1e-4);
  hull.round = 0.1;
  check(Seen(hull), Vector2d(0.5, -0.5) / 1.1);
  hull.texture = kNone;
  CHECK(Seen(hull).texcoords.empty());
}

TEST_CASE("a hull with a picture collides as it is seen") {
  Fault fault;
  const Hull hull = {.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3}}};
  const std::optional<Solid> solid = Make(hull, fault);
  REQUIRE(solid);
  CHECK(solid->pieces.empty());
  CHECK(solid->look.vertices.size() == 12);
  const auto is_exact = [](const Vector3d& p) { return p.z() == 0 || p.z() == 1.0 / 3; };
  CHECK(std::ranges::all_of(solid->look.vertices, is_exact));
}

TEST_CASE("level discs of turned shapes get a picture in metres from above") {
  const Surface top =
      Seen(Lathe{.profile = {{0, 0}, {0.3, 0}, {0.32, 0.01}, {0.3, 0.02}, {0, 0.02}},
                 .crease = kPi,
                 .texture = {Texture::Unit::kMetre, {10, 4}}});
  int level = 0;
  for (std::size_t i = 0; i < top.vertices.size(); ++i) {
    const Vector3d& p = top.vertices[i];
    const Vector2d want(10 * p.x(), -4 * p.y());
    level += (top.texcoords[i] - want).norm() < 2e-5 ? 1 : 0;
    if (p.head<2>().norm() < 1e-9) CHECK((top.texcoords[i] - want).norm() < 2e-5);
  }
  CHECK(level >= 2 * 49 + 2);  // two rims and middles; elsewhere it goes around
  CHECK(level < static_cast<int>(top.vertices.size()) - 49);
  // The edge is as smooth as without a texture.
  std::set<std::array<double, 3>> normals;
  for (std::size_t i = 0; i < top.vertices.size(); ++i) {
    if ((top.vertices[i] - Vector3d(0.3, 0, 0.02)).norm() < 1e-9)
      normals.insert({top.normals[i].x(), top.normals[i].y(), top.normals[i].z()});
  }
  CHECK(normals.size() == 1);
}

TEST_CASE("vertices are at whole micrometres, those of very small or large shapes are not") {
  for (const double size : {1e-6, 1e-3, 2e-3, 0.05, 9.0, 50.0}) {
    CAPTURE(size);
    const Surface look = Can(size * 0.7, size);
    CHECK(look.in_micrometres == (size >= 2e-3 && size <= 10));
    if (!look.in_micrometres) continue;
    for (const Vector3d& p : look.vertices) {
      const Vector3d whole = (p * 1e6).array().round();
      CHECK((p * 1e6 - whole).norm() < 1e-6);
    }
  }
}

}  // namespace
}  // namespace mjforge::solid
