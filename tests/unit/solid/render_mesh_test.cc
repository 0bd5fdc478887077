// Tests of render meshes: chord errors, normals, texture coordinates, rounding.

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>

#include "mjforge/solid/render_mesh.h"
#include "reference_geometry.h"

namespace mjforge::solid {
namespace {

template <typename Shape>
TriangleMesh MeshOf(const Shape& shape) {
  return Made(shape).render_mesh;
}

const TextureMapping kNone = {.unit = TextureMapping::Unit::kNone};

TriangleMesh Can(double radius, double height, double angle = 2 * kPi) {
  return MeshOf(Lathe{.profile = {{0, 0}, {radius, 0}, {radius, height}, {0, height}},
                      .angle = angle,
                      .texture = kNone});
}

/// Returns the largest distance of a chord's middle from the circle with this radius about the z
/// axis.
double ChordError(const TriangleMesh& mesh, double radius) {
  const auto distance = [&](const Vector3d& p) { return radius - p.head<2>().norm(); };
  double error = 0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vector3d& a = mesh.vertices[std::size_t(t[std::size_t(i)])];
      const Vector3d& b = mesh.vertices[std::size_t(t[std::size_t((i + 1) % 3)])];
      if (std::max(distance(a), distance(b)) < 2e-6) error = std::max(error, distance((a + b) / 2));
    }
  }
  return error;
}

std::size_t RimCount(const TriangleMesh& mesh, double radius) {
  std::set<std::pair<double, double>> places;
  for (const Vector3d& p : mesh.vertices) {
    if (p.head<2>().norm() > radius - 2e-6) places.emplace(p.x(), p.y());
  }
  return places.size();
}

/// Returns vertex normals by MuJoCo's rule: the mean of the triangles' normals weighted by area.
std::vector<Vector3d> ComputedNormals(const TriangleMesh& mesh) {
  std::vector<Vector3d> normals(mesh.vertices.size(), Vector3d::Zero());
  for (const std::array<int, 3>& t : mesh.triangles) {
    const auto at = [&](int i) { return mesh.vertices[std::size_t(t[std::size_t(i)])]; };
    for (const int corner : t) normals[std::size_t(corner)] += (at(1) - at(0)).cross(at(2) - at(0));
  }
  for (Vector3d& normal : normals) normal.normalize();
  return normals;
}

/// Returns the largest angle between computed and exact normals, deg.
double Lean(const TriangleMesh& mesh) {
  const std::vector<Vector3d> computed = ComputedNormals(mesh);
  double most = 0;
  for (std::size_t i = 0; i < computed.size(); ++i)
    most = std::max(most, std::acos(std::min(1.0, computed[i].dot(mesh.normals[i].normalized()))));
  return most * 180 / kPi;
}

/// Returns the numbers of the first and the last triangle of a wall about the z axis, with normals
/// that point outwards or inwards.
std::pair<std::size_t, std::size_t> PlacesOf(const TriangleMesh& mesh, double direction) {
  std::pair<std::size_t, std::size_t> places(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto at = [&](int k) -> const Vector3d& {
      return mesh.vertices[std::size_t(mesh.triangles[i][std::size_t(k)])];
    };
    const Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    const Vector2d middle = ((at(0) + at(1) + at(2)) / 3).head<2>().normalized();
    if (direction * normal.head<2>().dot(middle) < 0.5) continue;
    places = {std::min(places.first, i), i};
  }
  return places;
}

TEST_CASE("the inside of a cup comes before its outside, and walls of holes before other faces") {
  const TriangleMesh cup = MeshOf(
      Lathe{.profile = {{0, 0}, {0.03, 0}, {0.04, 0.1}, {0.037, 0.1}, {0.027, 0.003}, {0, 0.003}},
            .texture = kNone});
  REQUIRE(PlacesOf(cup, 1).second > 0);
  CHECK(PlacesOf(cup, -1).second < PlacesOf(cup, 1).first);
  const auto circle = [](double radius) {
    std::vector<Vector2d> points;
    for (int i = 0; i < 24; ++i)
      points.emplace_back(radius * std::cos(kPi * i / 12), radius * std::sin(kPi * i / 12));
    return points;
  };
  const TriangleMesh ring = MeshOf(
      Prism{.polygon = circle(0.03), .holes = {circle(0.02)}, .height = 0.01, .texture = kNone});
  CHECK(PlacesOf(ring, -1).first == 0);
  CHECK(PlacesOf(ring, -1).second == 47);
}

TEST_CASE("chords are near the true circle, and no more than that takes") {
  for (const double radius : {0.003, 0.01, 0.03, 0.045, 0.1, 0.5}) {
    for (const double height : {0.001, 0.05, 0.2}) {
      CAPTURE(radius, height);
      const TriangleMesh mesh = Can(radius, height);
      const double half = std::max(radius, height / 2);
      const std::size_t count = RimCount(mesh, radius);
      CHECK((ChordError(mesh, radius) < std::min(0.25e-3, 0.005 * half) + 2e-6 || count == 48));
      CHECK(std::set<std::size_t>{16, 32, 48}.contains(count));
    }
  }
  CHECK(RimCount(Can(0.04, 0.1), 0.04) == 32);
  CHECK(RimCount(Can(0.004, 0.1), 0.004) == 16);
  // A small part of a large circle has the same chord error.
  CHECK(RimCount(Can(2, 0.1, 0.2), 2) == 10);
  CHECK(ChordError(Can(2, 0.1, 0.2), 2) < 0.25e-3 + 2e-6);
}

TEST_CASE("without a texture each edge of a smooth surface is that of two triangles") {
  const TriangleMesh ring =
      MeshOf(Lathe{.profile = {{0.03, 0}, {0.04, 0}, {0.04, 0.01}, {0.03, 0.01}},
                   .crease = kPi,
                   .texture = kNone});
  const TriangleMesh wheel =
      MeshOf(Tube{.path = {{0, 0, 0}, {0.2, 0, 0}, {0.2, 0.2, 0}, {0, 0.2, 0}},
                  .radii = {0.01, 0.01, 0.01, 0.01},
                  .bend = 0.05,
                  .closed = true,
                  .texture = kNone});
  for (const TriangleMesh* mesh : {&ring, &wheel}) {
    std::map<std::pair<int, int>, int> edges;
    for (const std::array<int, 3>& t : mesh->triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
      CHECK(count == 1);
      CHECK(edges.contains({edge.second, edge.first}));
    }
    CHECK(mesh->texcoords.empty());
  }
}

TEST_CASE("normals that MuJoCo computes of the triangles hardly differ from the true ones") {
  Lathe vase = {.profile = {{0, 0}, {0.03, 0}}, .texture = kNone};
  for (int i = 1; i <= 12; ++i)
    vase.profile.emplace_back(0.03 + 0.01 * std::sin(i * 0.4), 0.01 * i);
  vase.profile.emplace_back(0, 0.12);
  CHECK(Lean(MeshOf(vase)) < 2);
  CHECK(Lean(MeshOf(Tube{.path = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}},
                         .radii = {0.01, 0.01, 0.01},
                         .bend = 0.03,
                         .texture = kNone})) < 5);
  CHECK(Lean(MeshOf(RoundedBox{.half = {0.05, 0.03, 0.02}, .round = 0.005, .texture = kNone})) <
        16);
  CHECK(Lean(MeshOf(Prism{.polygon = {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}},
                          .height = 0.01,
                          .round = 0.02,
                          .texture = kNone})) < 8);
}

TEST_CASE("boxes and hulls get their picture from above, as MuJoCo's own boxes") {
  RoundedBox box = {.half = {0.05, 0.03, 0.02}, .round = 0.005, .texture = {.repeat = {2, 3}}};
  const auto check = [](const TriangleMesh& mesh, const Vector2d& scale) {
    REQUIRE(mesh.texcoords.size() == mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const Vector2d want = (mesh.vertices[i].head<2>().cwiseProduct(scale).array() + 0.5).matrix();
      CHECK((mesh.texcoords[i] - want).norm() < 5e-5);
    }
  };
  check(MeshOf(box), Vector2d(2 / 0.1, -3 / 0.06));
  box.texture.unit = TextureMapping::Unit::kMetre;
  check(MeshOf(box), Vector2d(2, -3));
  ConvexHull hull = {.points = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}};
  const TriangleMesh pyramid = MeshOf(hull);
  check(pyramid, Vector2d(0.5, -0.5));
  CHECK(pyramid.vertices.size() == 16);  // each face has its own
  CHECK(Lean(pyramid) < 1e-4);
  hull.round = 0.1;
  check(MeshOf(hull), Vector2d(0.5, -0.5) / 1.1);
  hull.texture = kNone;
  CHECK(MeshOf(hull).texcoords.empty());
}

TEST_CASE("a hull with a picture collides as it is seen") {
  Fault fault;
  const ConvexHull hull = {.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.0 / 3}}};
  const std::optional<Solid> solid = Make(hull, fault);
  REQUIRE(solid);
  CHECK(solid->pieces.empty());
  CHECK(solid->render_mesh.vertices.size() == 12);
  const auto is_exact = [](const Vector3d& p) { return p.z() == 0 || p.z() == 1.0 / 3; };
  CHECK(std::ranges::all_of(solid->render_mesh.vertices, is_exact));
}

TEST_CASE("level discs of turned shapes get a picture in metres from above") {
  const TriangleMesh top =
      MeshOf(Lathe{.profile = {{0, 0}, {0.3, 0}, {0.32, 0.01}, {0.3, 0.02}, {0, 0.02}},
                   .crease = kPi,
                   .texture = {TextureMapping::Unit::kMetre, {10, 4}}});
  int level = 0;
  for (std::size_t i = 0; i < top.vertices.size(); ++i) {
    const Vector3d& p = top.vertices[i];
    const Vector2d want(10 * p.x(), -4 * p.y());
    level += (top.texcoords[i] - want).norm() < 2e-5 ? 1 : 0;
    if (p.head<2>().norm() < 1e-9) CHECK((top.texcoords[i] - want).norm() < 2e-5);
  }
  // Two rims and middles; elsewhere the texture goes around the axis.
  CHECK(level >= 2 * 49 + 2);
  CHECK(level < static_cast<int>(top.vertices.size()) - 49);
  // The edge is shaded smoothly, as without a texture.
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
    const TriangleMesh mesh = Can(size * 0.7, size);
    CHECK(mesh.in_micrometres == (size >= 2e-3 && size <= 10));
    if (!mesh.in_micrometres) continue;
    for (const Vector3d& p : mesh.vertices) {
      const Vector3d whole = (p * 1e6).array().round();
      CHECK((p * 1e6 - whole).norm() < 1e-6);
    }
  }
}

TEST_CASE("coordinates are rounded to the nearest, halves away from zero") {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 1, 1}};  // 1 m: rounded to whole micrometres
  for (int i = -40; i <= 40; ++i) {
    const double half = 0.5e-6 * i;
    for (const double number : {half, std::nextafter(half, -1), std::nextafter(half, 1)}) {
      mesh.vertices.emplace_back(number, -number, 0.25 + number);
    }
  }
  TriangleMesh rounded = mesh;
  RoundCoordinates(rounded);
  REQUIRE(rounded.in_micrometres);
  int halves = 0;
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const double number = mesh.vertices[i][k];
      CAPTURE(number);
      CHECK(rounded.vertices[i][k] == std::round(number * 1e6) / 1e6);
      CHECK((rounded.vertices[i][k] != 0 || !std::signbit(rounded.vertices[i][k])));
      halves += std::abs(std::fmod(number * 1e6, 1)) == 0.5 ? 1 : 0;
    }
  }
  CHECK(halves > 40);
}

/// Returns the largest distance of a point of the mesh from the surface, of which `distance` is the
/// signed distance.
template <typename Distance>
double LargestError(const TriangleMesh& mesh, const Distance& distance) {
  double largest = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vector3d& a = mesh.vertices[std::size_t(i)];
    const Vector3d& b = mesh.vertices[std::size_t(j)];
    const Vector3d& c = mesh.vertices[std::size_t(k)];
    for (double u = 0; u <= 1; u += 0.125) {
      for (double v = 0; u + v <= 1; v += 0.125)
        largest = std::max(largest, std::abs(distance(a + u * (b - a) + v * (c - a))));
    }
  }
  return largest;
}

/// Returns the signed distance from a body whose core ends `beyond` before the point, in each of
/// some directions, and that is rounded.
template <typename Vector>
double FromRounded(const Vector& beyond, double round) {
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - round;
}

// Chords are at most 0.25 mm off; where a face is curved both ways, both chords add up, and at a
// corner the distance from the middle of a triangle to its corners counts.
TEST_CASE("faces that are curved both ways are off by more than a chord, as the manual states") {
  const double chord = 0.25e-3;
  double of_ring = 0;
  double of_can = 0;
  double of_box = 0;
  for (double scale = 0.5; scale < 2; scale *= 1.1) {
    const double R = 0.05 * scale;
    const double r = 0.03 * scale;
    const double round = 0.025 * scale;
    const Vector3d core(R - round, R - round, r - round);
    const TriangleMesh ring = MeshOf(Tube{.path = {{-R, -R, 0}, {R, -R, 0}, {R, R, 0}, {-R, R, 0}},
                                          .radii = {r, r, r, r},
                                          .bend = R,
                                          .closed = true});
    of_ring = std::max(of_ring, LargestError(ring, [&](const Vector3d& p) {
                         return Vector2d(p.head<2>().norm() - R, p.z()).norm() - r;
                       }));
    const TriangleMesh can = MeshOf(RoundedCylinder{.radius = R, .half = r, .round = round});
    of_can = std::max(of_can, LargestError(can, [&](const Vector3d& p) {
                        const Vector2d q(p.head<2>().norm(), std::abs(p.z()));
                        return FromRounded(Vector2d(q - core.tail<2>()), round);
                      }));
    const TriangleMesh box = MeshOf(RoundedBox{.half = {R, R, r}, .round = round});
    of_box = std::max(of_box, LargestError(box, [&](const Vector3d& p) {
                        return FromRounded(Vector3d(p.cwiseAbs() - core), round);
                      }));
  }
  CHECK(of_ring > 1.9 * chord);
  CHECK(of_ring < 2.2 * chord);
  CHECK(of_can > 1.5 * chord);
  CHECK(of_can < 2.2 * chord);
  CHECK(of_box > 2.4 * chord);
  CHECK(of_box < 2.65 * chord);
}

}  // namespace
}  // namespace mjforge::solid
