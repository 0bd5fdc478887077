// Tests of the point test of shapes and objects.

#include <random>

#include <catch2/catch.hpp>

#include "mjforge/model/model.h"

namespace mjforge::model {
namespace {

using Eigen::Vector3d;

TEST_CASE("points of the surface are inside, points off it are not") {
  struct Row {
    GeomType type;
    Vector3d surface;  // a point on the surface, relative to the centre
  };
  const Vector3d size(1, 2, 3);
  const Pose X_AG = {.p = {0.3, -0.7, 11}, .q = FromEuler({0.1, 0.7, -2})};
  for (const Row& row :
       {Row{GeomType::kSphere, Vector3d(2, 2, 1) / 3}, Row{GeomType::kCapsule, {0, 0.6, 2.8}},
        Row{GeomType::kEllipsoid, {0.6, 1.6, 0}}, Row{GeomType::kCylinder, {0.6, 0.8, 2}},
        Row{GeomType::kBox, {1, 2, 3}}}) {
    const Shape shape = {.type = row.type, .size = size};
    INFO(GeomTypeName(row.type));
    CHECK(Contains(shape, X_AG, X_AG.p));
    CHECK(Contains(shape, X_AG, X_AG * row.surface));
    CHECK(Contains(shape, X_AG, X_AG * Vector3d(row.surface * (1 - 1e-9))));
    CHECK_FALSE(Contains(shape, X_AG, X_AG * Vector3d(row.surface * (1 + 1e-9))));
  }
}

TEST_CASE("a prism contains what the box of its outline contains") {
  const std::vector<Eigen::Vector2d> corners = {{-1, -2}, {1, -2}, {1, 2}, {-1, 2}};
  const std::optional<TriangleMesh> mesh = solid::MakeConvexPrism(corners, 6);
  REQUIRE(mesh);
  const Shape prism = {.type = GeomType::kMesh, .mesh = &*mesh};
  const Shape box = {.type = GeomType::kBox, .size = {1, 2, 3}};
  const Pose X_AG = {.p = {1, 2, 3}, .q = FromEuler({1, 2, 3})};
  std::mt19937 random(3);
  const auto draw = [&random] { return 8.0 * static_cast<double>(random()) / 4294967296.0 - 4; };
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d p = X_AG * Vector3d(draw(), draw(), draw());
    CHECK(Contains(prism, X_AG, p) == Contains(box, X_AG, p));
    inside += Contains(box, X_AG, p);
  }
  CHECK(inside > 50);
  CHECK(Contains(prism, X_AG, X_AG * Vector3d(1, 0, 0)));
  CHECK(Contains(prism, X_AG, X_AG * Vector3d(1, 2, 3)));
}

Part Ball(const Vector3d& p, Role role) {
  Part part;
  part.role = role;
  part.shape = {.type = GeomType::kSphere, .size = {1, 0, 0}};
  part.X_BG.p = p;
  return part;
}

TEST_CASE("an object contains the points of its collision parts in its own frame") {
  Object object;
  object.bodies.resize(2);
  object.bodies[0].X_PB.p = {100, 0, 0};
  object.bodies[0].parts = {Ball({2, 0, 0}, Role::kBoth), Ball({-2, 0, 0}, Role::kVisual)};
  object.bodies[1].parent = 0;
  object.bodies[1].X_PB.p = {0, 5, 0};
  object.bodies[1].parts = {Ball({0, 0, 0}, Role::kCollision)};
  CHECK(Contains(object, {103, 0, 0}));
  CHECK_FALSE(Contains(object, {100, 0, 0}));
  CHECK_FALSE(Contains(object, {98, 0, 0}));
  CHECK(Contains(object, {100, 4, 0}));
}

}  // namespace
}  // namespace mjforge::model
