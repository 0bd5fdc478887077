#include "mjforge/files/files.h"

#include <catch2/catch.hpp>

#include "harness/png.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::files {
namespace {

void AddMesh(model::Object& object, const std::string& name, double height) {
  auto mesh = std::make_unique<model::MeshAsset>();
  mesh->name = name;
  mesh->mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, height}};
  mesh->mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  object.meshes.push_back(std::move(mesh));
}

void AddTexture(model::Object& object, const std::string& name) {
  model::Texture texture;
  texture.name = name;
  texture.attributes = {{.name = "type", .numbers = {}, .text = "2d"},
                        {.name = "builtin", .numbers = {}, .text = "flat"},
                        {.name = "rgb1", .numbers = {0.2, 0.4, 0.6}, .text = {}},
                        {.name = "width", .numbers = {2}, .text = {}},
                        {.name = "height", .numbers = {3}, .text = {}}};
  object.textures.push_back(texture);
}

mjcf::MjcfDocument Written(const model::Object& object) {
  mjcf::Provenance provenance;
  provenance.assets_as = "files";
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(object, mjcf::Target::kMujoco, provenance, document);
  return document;
}

TEST_CASE("files are named after what they are of and what is in them") {
  model::Object object;
  object.name = "jar";
  AddMesh(object, "jar_Lid", 1);
  AddTexture(object, "jar_glass");
  mjcf::MjcfDocument document = Written(object);
  CHECK(document.text.find("file=\"assets/lid_0000000000000000.obj\"") != std::string::npos);
  diag::Findings findings;
  Maker maker;
  REQUIRE(maker.Make(object, document, findings));
  CHECK(findings.empty());
  REQUIRE(document.assets.size() == 2);
  const auto& [picture_name, no_file, picture] = document.assets[0];
  CHECK(no_file.empty());
  CHECK(picture_name.starts_with("assets/flat_"));
  CHECK(document.text.find("<texture name=\"jar_glass\" type=\"2d\" file=\"" + picture_name +
                           "\"/>") != std::string::npos);
  const harness::Png png = harness::DecodePng(*picture);
  CHECK(png.width == 2);
  CHECK(png.height == 3);
  CHECK(png.At(1, 2) == std::array<int, 4>{51, 102, 153, 255});
  const bytes::Asset& mesh = document.assets[1];
  CHECK(mesh.name == "assets/lid_" + bytes::ChecksumOf(*mesh.made).substr(0, 16) + ".obj");
  CHECK(document.text.find("<mesh name=\"jar_Lid\" file=\"" + mesh.name + "\"/>") !=
        std::string::npos);
  CHECK(document.generated_files.empty());
}

TEST_CASE("equal contents have equal names, others have others") {
  model::Object object;
  object.name = "jar";
  AddMesh(object, "jar_lid", 1);
  AddTexture(object, "jar_glass");
  AddTexture(object, "jar_other_glass");
  mjcf::MjcfDocument one = Written(object);
  diag::Findings findings;
  Maker maker;
  REQUIRE(maker.Make(object, one, findings));
  CHECK(one.assets.size() == 2);  // both textures are one file
  object.name = "pot";
  object.meshes[0]->name = "pot_lid";
  mjcf::MjcfDocument renamed = Written(object);
  REQUIRE(maker.Make(object, renamed, findings));
  CHECK(renamed.assets == one.assets);
  object.meshes[0]->mesh.vertices[3].z() = 1.5;
  mjcf::MjcfDocument other = Written(object);
  REQUIRE(Maker().Make(object, other, findings));
  CHECK(other.assets[0] == one.assets[0]);
  CHECK(other.assets[1].name != one.assets[1].name);
}

TEST_CASE("names have only what every system takes, and fit into archives") {
  model::Object object;
  object.name = "jar";
  AddMesh(object, "jar_a/b c" + std::string(200, 'x'), 1);
  mjcf::MjcfDocument document = Written(object);
  diag::Findings findings;
  REQUIRE(Maker().Make(object, document, findings));
  const std::string& name = document.assets.at(0).name;
  CHECK(name.starts_with("assets/a_b_cxxx"));
  CHECK(name.size() < 100);
}

TEST_CASE("a mesh without faces and without a hull is a finding") {
  model::Object object;
  object.name = "jar";
  AddMesh(object, "jar_lid", 1);
  object.meshes[0]->attributes = {
      {.name = "vertex", .numbers = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, .text = {}}};
  mjcf::MjcfDocument document = Written(object);
  diag::Findings findings;
  CHECK_FALSE(Maker().Make(object, document, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings.begin()->message ==
        "mesh 'jar_lid' has no faces, and its hull has no volume: all points lie in a plane");
}

}  // namespace
}  // namespace mjforge::files
