// Tests of convex prisms: which polygons are convex, which corners remain, mass.

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "reference_geometry.h"

namespace mjforge::solid {
namespace {

using Points = std::vector<Vector2d>;

TriangleMesh Made(const Points& polygon, double height) {
  std::optional<TriangleMesh> mesh = MakeConvexPrism(polygon, height);
  REQUIRE(mesh);
  return *std::move(mesh);
}

TEST_CASE("a prism is centred on z = 0 and faces outwards whichever way its corners go") {
  for (const Points& polygon :
       {Points{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{0, 1}, {2, 1}, {2, 0}, {0, 0}}}) {
    const TriangleMesh mesh = Made(polygon, 3);
    CHECK(mesh.vertices.size() == 8);
    CHECK(mesh.triangles.size() == 12);
    CHECK(VolumeOf(mesh) == Approx(6).epsilon(1e-14));
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : mesh.vertices) box.extend(p);
    CHECK(box.min() == Vector3d(0, 0, -1.5));
    CHECK(box.max() == Vector3d(2, 1, 1.5));
  }
}

TEST_CASE("repeated corners and corners on a straight side are left out") {
  CHECK(Made({{0, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}}, 1).vertices.size() == 8);
}

TEST_CASE("polygons without area make no convex prism") {
  for (const Points& polygon : {Points{},
                                {{0, 0}, {1, 1}},
                                {{0, 0}, {1, 1}, {1, 1}, {0, 0}},
                                {{0, 0}, {1, 1}, {2, 2}},
                                {{0, 0}, {1, 0}, {std::nan(""), 1}}}) {
    CAPTURE(polygon.size());
    CHECK_FALSE(MakeConvexPrism(polygon, 1));
  }
}

TEST_CASE("polygons with dents or spikes make no convex prism") {
  CHECK_FALSE(MakeConvexPrism(Points{{0, 0}, {4, 0}, {1, 1}, {0, 4}}, 1));
  CHECK_FALSE(MakeConvexPrism(Points{{0, 4}, {1, 1}, {4, 0}, {0, 0}}, 1));
  CHECK_FALSE(MakeConvexPrism(Points{{0, 0}, {4, 0}, {4, 4}, {8, 4}, {4, 4}, {0, 4}}, 1));
}

TEST_CASE("a star that turns one way all the time is not convex") {
  Points star;  // the pentagram 0, 2, 4, 1, 3 of a regular pentagon
  for (const int i : {0, 2, 4, 1, 3})
    star.emplace_back(std::cos(2 * kPi * i / 5), std::sin(2 * kPi * i / 5));
  CHECK_FALSE(MakeConvexPrism(star, 1));
}

TEST_CASE("a convex prism without a texture is one piece with the mass of its mesh") {
  Random random(25);
  for (int i = 0; i < harness::Effort(300); ++i) {
    CAPTURE(i);
    Prism prism = {.polygon = {}, .height = random.Uniform(0.01, 1)};
    prism.texture.unit = TextureMapping::Unit::kNone;
    const int count = 3 + random.Integer(10);
    for (int k = 0; k < count; ++k) {
      const double turn = 2 * kPi * (k + random.Uniform(0, 0.9)) / count;
      prism.polygon.emplace_back(0.3 + std::cos(turn), 0.5 * std::sin(turn));
    }
    if (i % 2 == 0) std::ranges::reverse(prism.polygon);
    Fault fault;
    const std::optional<Solid> solid = Make(prism, fault);
    REQUIRE(solid);
    REQUIRE(solid->pieces.size() == 1);
    CHECK(solid->render_mesh.vertices.empty());
    const TriangleMesh& mesh = solid->pieces[0].mesh;
    CHECK(mesh.vertices == Made(prism.polygon, prism.height).vertices);
    CHECK(Difference(solid->mass, Enclosed(mesh)) < 1e-9);
    prism.texture.unit = TextureMapping::Unit::kMetre;
    CHECK(Difference(Make(prism, fault)->mass, solid->mass) < 1e-9);
    CHECK_FALSE(Make(prism, fault)->render_mesh.texcoords.empty());
  }
}

TEST_CASE("a convex prism with a repeated corner stays one piece if it has a texture") {
  const Prism prism = {.polygon = {{0, 0}, {1, 0}, {1, 0}, {0, 1}}, .height = 1};
  Fault fault;
  const std::optional<Solid> solid = Make(prism, fault);
  REQUIRE(solid);
  CHECK(solid->pieces.size() == 1);
  CHECK(solid->render_mesh.vertices.empty());
}

}  // namespace
}  // namespace mjforge::solid
