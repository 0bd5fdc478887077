// Tests of mass properties of shapes and meshes.

#include <catch2/catch.hpp>

#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

TEST_CASE("masses and inertias are those of the books") {
  const MassProperties sphere = MassOf({.type = GeomType::kSphere, .size = {2, 0, 0}}, 3);
  CHECK(sphere.mass == Approx(32 * M_PI));
  CHECK(sphere.I_Cm_F(0, 0) == Approx(sphere.mass * 1.6));
  const MassProperties cylinder = MassOf({.type = GeomType::kCylinder, .size = {1, 2, 0}}, 1);
  CHECK(cylinder.mass == Approx(4 * M_PI));
  CHECK(cylinder.I_Cm_F(0, 0) == Approx(cylinder.mass * (3 + 16) / 12));
  CHECK(cylinder.I_Cm_F(2, 2) == Approx(cylinder.mass / 2));
  const MassProperties box = MassOf({.type = GeomType::kBox, .size = {1, 2, 3}}, 1);
  CHECK(box.mass == 48);
  CHECK(box.I_Cm_F(0, 0) == 208);
  const MassProperties ellipsoid = MassOf({.type = GeomType::kEllipsoid, .size = {1, 2, 3}}, 1);
  CHECK(ellipsoid.mass == Approx(8 * M_PI));
  CHECK(ellipsoid.I_Cm_F(2, 2) == Approx(ellipsoid.mass));
}

TEST_CASE("a capsule without straight part is a sphere") {
  const MassProperties capsule = MassOf({.type = GeomType::kCapsule, .size = {2, 0, 0}}, 1);
  const MassProperties sphere = MassOf({.type = GeomType::kSphere, .size = {2, 0, 0}}, 1);
  CHECK(capsule.mass == Approx(sphere.mass).epsilon(1e-14));
  CHECK(capsule.I_Cm_F.isApprox(sphere.I_Cm_F, 1e-14));
}

// A box with corners (0, 0, -h/2) to (a, b, h/2), far from the origin of its frame.
TEST_CASE("a mesh has the mass properties of the solid it bounds") {
  const double x = 100;
  const std::vector<Eigen::Vector2d> corners = {{x, 0}, {x + 2, 0}, {x + 2, 4}, {x, 4}};
  const std::optional<TriangleMesh> mesh = solid::MakeConvexPrism(corners, 6);
  REQUIRE(mesh);
  const MassProperties prism = MassOf({.type = GeomType::kMesh, .mesh = &*mesh}, 2);
  const MassProperties box = MassOf({.type = GeomType::kBox, .size = {1, 2, 3}}, 2);
  CHECK(prism.mass == Approx(box.mass).epsilon(1e-13));
  CHECK((prism.p_FCm - Eigen::Vector3d(101, 2, 0)).norm() < 1e-12);
  CHECK(prism.I_Cm_F.isApprox(box.I_Cm_F, 1e-13));
}

// An L of three unit cubes: a concave solid, for which the convex hull would be wrong.
TEST_CASE("a concave mesh has the mass properties of its cubes") {
  const std::vector<Eigen::Vector2d> outline = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  TriangleMesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const Eigen::Vector2d& p : outline) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  for (const std::array<int, 3>& t :
       {std::array<int, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    mesh.triangles.push_back({t[0], t[2], t[1]});
    mesh.triangles.push_back({t[0] + 6, t[1] + 6, t[2] + 6});
  }
  for (int i = 0; i < 6; ++i) {
    const int next = (i + 1) % 6;
    mesh.triangles.push_back({i, next, next + 6});
    mesh.triangles.push_back({i, next + 6, i + 6});
  }
  REQUIRE(FindSurfaceDefect(mesh) == std::nullopt);
  MassProperties cubes;
  const Shape cube = {.type = GeomType::kBox, .size = {0.5, 0.5, 0.5}};
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(0.5, 0.5, 0.5), {1.5, 0.5, 0.5}, {0.5, 1.5, 0.5}}) {
    cubes = Combine(cubes, InFrame({.p = p}, MassOf(cube, 1)));
  }
  const MassProperties solid = MassOf({.type = GeomType::kMesh, .mesh = &mesh}, 1);
  CHECK(solid.mass == Approx(3).epsilon(1e-14));
  CHECK((solid.p_FCm - cubes.p_FCm).norm() < 1e-14);
  CHECK(solid.I_Cm_F.isApprox(cubes.I_Cm_F, 1e-13));
}

TEST_CASE("a turned body turns its inertia") {
  const MassProperties box = MassOf({.type = GeomType::kBox, .size = {1, 2, 3}}, 1);
  const MassProperties turned = InFrame({.p = {5, 0, 0}, .q = FromEuler({0, 0, M_PI / 2})}, box);
  CHECK(turned.p_FCm == Eigen::Vector3d(5, 0, 0));
  CHECK(turned.I_Cm_F(0, 0) == Approx(box.I_Cm_F(1, 1)));
  CHECK(turned.I_Cm_F(1, 1) == Approx(box.I_Cm_F(0, 0)));
}

TEST_CASE("two halves combine to the whole") {
  const Shape half = {.type = GeomType::kBox, .size = {1, 1, 1}};
  const MassProperties whole = Combine(InFrame({.p = {-1, 0, 0}}, MassOf(half, 1)),
                                       InFrame({.p = {1, 0, 0}}, MassOf(half, 1)));
  const MassProperties box = MassOf({.type = GeomType::kBox, .size = {2, 1, 1}}, 1);
  CHECK(whole.mass == box.mass);
  CHECK(whole.p_FCm.norm() == 0);
  CHECK(whole.I_Cm_F.isApprox(box.I_Cm_F, 1e-15));
}

TEST_CASE("nothing combined with nothing is nothing") {
  CHECK(Combine({}, {}).mass == 0);
  CHECK(Combine({}, {}).p_FCm.norm() == 0);
}

}  // namespace
}  // namespace mjforge::model
