#include "mjforge/files/obj.h"

#include <catch2/catch.hpp>

#include "attributes.h"

namespace mjforge::files {
namespace {

model::MeshAsset Triangle() {
  model::MeshAsset asset;
  asset.mesh.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.25, 1e-7}};
  asset.mesh.triangles = {{0, 1, 2}};
  return asset;
}

std::string TextOf(const model::MeshAsset& asset) {
  std::string why_not;
  return ObjOf(asset, why_not).value_or(why_not);
}

TEST_CASE("a mesh becomes vertices and faces, which count from 1") {
  CHECK(TextOf(Triangle()) ==
        "v 0 0 0\n"
        "v 0.1 0 0\n"
        "v 0 0.25 1e-07\n"
        "f 1 2 3\n");
}

TEST_CASE("faces say which normals and texture coordinates there are") {
  model::MeshAsset asset = Triangle();
  asset.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  CHECK(TextOf(asset).ends_with("vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nf 1//1 2//2 3//3\n"));
  asset.mesh.texcoords = {{0, 0}, {2, 0.25}, {0, 1}};
  CHECK(TextOf(asset).find("vt 0 1\nvt 2 0.75\nvt 0 0\nvn ") != std::string::npos);
  CHECK(TextOf(asset).ends_with("f 1/1/1 2/2/2 3/3/3\n"));
  asset.mesh.normals.clear();
  CHECK(TextOf(asset).ends_with("f 1/1 2/2 3/3\n"));
}

TEST_CASE("the inline mesh of an attached file is what its element says") {
  model::MeshAsset asset = Triangle();
  asset.attributes = {Numbers("vertex", {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3}),
                      Numbers("face", {0, 2, 1, 0, 3, 2})};
  CHECK(TextOf(asset) == "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 4 3\n");
}

TEST_CASE("one without faces gets those of its hull, seen from outside") {
  model::MeshAsset asset;
  asset.attributes = {Numbers("vertex", {0, 0, 0, 0.1, 0.1, 0.1, 1, 0, 0, 0, 2, 0, 0, 0, 3})};
  std::string why_not;
  const std::string obj = ObjOf(asset, why_not).value();
  CHECK(std::ranges::count(obj, 'v') == 5);
  CHECK(std::ranges::count(obj, 'f') == 4);
  CHECK(obj.find(" 2 ", obj.find('f')) == std::string::npos);  // the one inside
  // The face in the plane z = 0 is clockwise from above.
  const bool seen_from_below = obj.find("f 1 4 3\n") != obj.npos ||
                               obj.find("f 4 3 1\n") != obj.npos ||
                               obj.find("f 3 1 4\n") != obj.npos;
  CHECK(seen_from_below);
}

TEST_CASE("points that have no hull are said to have none") {
  model::MeshAsset asset;
  asset.attributes = {Numbers("vertex", {0, 0, 0, 1, 0, 0, 0, 2, 0, 1, 1, 0})};
  CHECK(TextOf(asset) == "has no volume: all points lie in a plane");
}

}  // namespace
}  // namespace mjforge::files
