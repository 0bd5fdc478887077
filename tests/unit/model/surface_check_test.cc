// Tests of the closed-surface test of meshes.

#include <catch2/catch.hpp>

#include "mjforge/model/shapes.h"

namespace mjforge::model {
namespace {

TriangleMesh Tetrahedron() {
  return {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

TEST_CASE("a closed mesh that faces outwards is solid") {
  CHECK(FindSurfaceDefect(Tetrahedron()) == std::nullopt);
}

TEST_CASE("a mesh with a hole is not solid") {
  TriangleMesh mesh = Tetrahedron();
  mesh.triangles.pop_back();
  CHECK(FindSurfaceDefect(mesh) == "edge shared by 1 triangle");
}

TEST_CASE("a mesh with a fin is not solid") {
  TriangleMesh mesh = Tetrahedron();
  mesh.vertices.emplace_back(2, 2, 2);
  mesh.triangles.push_back({0, 1, 4});
  mesh.triangles.push_back({1, 2, 4});
  mesh.triangles.push_back({2, 0, 4});
  CHECK(FindSurfaceDefect(mesh) == "edge shared by 3 triangles");
}

TEST_CASE("a mesh with one triangle turned over is not solid") {
  TriangleMesh mesh = Tetrahedron();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  CHECK(FindSurfaceDefect(mesh) == "neighbouring triangles face opposite ways");
}

TEST_CASE("a mesh that faces inwards is inside out") {
  TriangleMesh mesh = Tetrahedron();
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  CHECK(FindSurfaceDefect(mesh) == "inside out");
}

TEST_CASE("a flat mesh has no volume") {
  const TriangleMesh mesh = {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                             .triangles = {{0, 1, 2}, {0, 2, 1}}};
  CHECK(FindSurfaceDefect(mesh) == "no volume");
}

TEST_CASE("a mesh without triangles is not solid") {
  CHECK(FindSurfaceDefect({}) == "no triangles");
}

}  // namespace
}  // namespace mjforge::model
