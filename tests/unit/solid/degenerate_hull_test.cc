// Tests of rounded hulls without volume: capsules, balls and slabs.

#include <map>

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "reference_geometry.h"

namespace mjforge::solid {
namespace {

/// Returns true if each edge of the mesh, whose vertices are joined where they are equal, belongs
/// to two triangles in opposite directions.
bool IsClosed(const TriangleMesh& mesh) {
  std::map<std::array<double, 3>, int> places;
  const auto at = [&](int i) {
    const Vector3d& p = mesh.vertices[std::size_t(i)];
    return places.try_emplace({p.x(), p.y(), p.z()}, int(places.size())).first->second;
  };
  std::map<std::pair<int, int>, int> edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (at(from) == at(to)) return false;
      ++edges[{at(from), at(to)}];
    }
  }
  return std::ranges::all_of(edges, [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

TEST_CASE("a round hull of two points is a capsule, one of a single point a ball") {
  const double r = 0.3;
  const Vector3d a(1, 2, 3);
  const Vector3d b(1.5, 1, 4);
  const double length = (b - a).norm();
  for (const bool more : {false, true}) {
    ConvexHull hull = {.points = {a, b}, .round = r};
    if (more) hull.points.insert(hull.points.begin(), {0.3 * a + 0.7 * b, a});
    const Solid solid = Made(hull);
    REQUIRE(solid.pieces.size() == 1);
    CHECK(solid.pieces[0].type == ConvexPiece::Type::kCapsule);
    CHECK(solid.pieces[0].size.x() == r);
    CHECK(solid.pieces[0].size.y() == Approx(length / 2));
    CHECK((solid.pieces[0].p - (a + b) / 2).norm() < 1e-12);
    CHECK(solid.mass.volume == Approx(kPi * r * r * (length + 4 * r / 3)).epsilon(1e-12));
    CHECK((solid.mass.center - (a + b) / 2).norm() < 1e-12);
    CHECK(IsClosed(solid.render_mesh));
    CHECK(Difference(Enclosed(solid.render_mesh), solid.mass) < 0.1);
    const Vector3d d = Vector3d(1, -2, 2) / 3;
    CHECK(Support(solid.extent, d) == Approx(std::max(a.dot(d), b.dot(d)) + r).epsilon(1e-12));
  }
  const Solid ball = Made(ConvexHull{.points = {a, a}, .round = r});
  REQUIRE(ball.pieces.size() == 1);
  CHECK(ball.pieces[0].type == ConvexPiece::Type::kSphere);
  CHECK(ball.mass.volume == Approx(4 * kPi / 3 * r * r * r).epsilon(1e-12));
  CHECK(IsClosed(ball.render_mesh));
}

TEST_CASE("a round hull of points in a plane is a slab") {
  Random random(38);
  for (int i = 0; i < harness::Effort(30); ++i) {
    CAPTURE(i);
    const double r = random.Uniform(0.1, 0.5);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), 1)
            .normalized();
    std::vector<Vector2d> flat;
    ConvexHull hull = {.points = {}, .round = r};
    for (int k = 0; k < 3 + i % 8; ++k) {
      flat.emplace_back(random.Uniform(-1, 1), random.Uniform(-1, 1));
      hull.points.push_back(turn * Vector3d(flat.back().x(), flat.back().y(), 0.7));
    }
    const std::vector<Vector2d> outline = ConvexPolygonOf(flat);
    double around = 0;
    for (std::size_t k = 0; k < outline.size(); ++k)
      around += (outline[(k + 1) % outline.size()] - outline[k]).norm();
    const Solid solid = Made(hull);
    // Steiner's formula: two faces, half a cylinder along all edges, and a ball.
    const double volume =
        2 * r * AreaOf(outline) + kPi / 2 * r * r * around + 4 * kPi / 3 * r * r * r;
    CHECK(solid.mass.volume == Approx(volume).epsilon(1e-9));
    CHECK(std::abs((turn.conjugate() * solid.mass.center).z() - 0.7) < 1e-9);
    CHECK(IsClosed(solid.render_mesh));
    CHECK(Difference(Enclosed(solid.render_mesh), solid.mass) < 0.1);
    CHECK(Support(solid.extent, turn * Vector3d(0, 0, 1)) == Approx(0.7 + r).epsilon(1e-9));
    REQUIRE(solid.pieces.size() == 1);
    CHECK(IsClosed(solid.pieces[0].mesh));
    // A piece with 8 segments to a turn is within the solid by 18 % of the radius at most.
    const Vector3d d = turn * Vector3d(random.Uniform(-1, 1), random.Uniform(-1, 1), 0.1);
    double reach = -1e9;
    for (const Vector3d& p : solid.pieces[0].mesh.vertices) reach = std::max(reach, p.dot(d));
    const double exact = Support(solid.extent, d);
    CHECK(reach < exact + 1e-9);
    CHECK(reach > exact - 0.19 * r * d.norm());
  }
}

}  // namespace
}  // namespace mjforge::solid
