#include "mjforge/mjcf/mjcf.h"

#include <catch2/catch.hpp>

#include "hand_made.h"

namespace mjforge::mjcf {
namespace {

Provenance SomeProvenance() {
  Provenance provenance;
  provenance.version = "0.1.0";
  provenance.spec = "mallet";
  provenance.spec_sha256 = "00ff";
  provenance.seed = 7;
  provenance.index = 41;
  return provenance;
}

TEST_CASE("a small object is written as it always was") {
  model::Object object = hand_made::Mallet();
  object.bodies.front().parts[1].X_BG.q = {0, 0, 0, 1};
  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, SomeProvenance(), document);
  CHECK(document.text ==
        R"(<!-- mjforge 0.1.0 spec=mallet sha256=00ff seed=7 index=41 -->
<mujoco model="mallet">
  <compiler angle="radian" usethread="false"/>
  <worldbody>
    <body name="mallet_root" pos="0 0 0">
      <joint name="mallet_joint0" type="free"/>
      <site name="mallet_foot" type="sphere" size="0.005" pos="0 0 -0.1"/>
      <geom name="mallet_handle" type="cylinder" size="0.01 0.1" pos="0 0 0" density="500" friction="0.9 0.01" group="3" rgba="0.5 0 0 1"/>
      <geom name="mallet_handle_vis" type="cylinder" size="0.01 0.1" pos="0 0 0" contype="0" conaffinity="0" mass="0" rgba="0.6 0.4 0.2 1" group="2"/>
      <geom name="mallet_head" type="box" size="0.04 0.02 0.025" pos="0 0 0.125" quat="0 0 0 1" density="500" group="3" rgba="0.5 0 0 1"/>
      <geom name="mallet_head_vis" type="box" size="0.04 0.02 0.025" pos="0 0 0.125" quat="0 0 0 1" contype="0" conaffinity="0" mass="0" group="2"/>
    </body>
  </worldbody>
</mujoco>
)");
}

TEST_CASE("lines know the entry of the spec they come from") {
  MjcfDocument document;
  WriteMjcf(hand_made::Mallet(), Target::kMujoco, SomeProvenance(), document);
  const std::uint32_t lines[] = {0, 0, 0, 0, 1, 2, 20, 11, 11, 12, 12, 0, 0, 0};
  for (int i = 0; i < 14; ++i) {
    INFO("line " << i + 1);
    CHECK(document.Origin(i + 1).line == lines[i]);
  }
}

TEST_CASE("a size element fits at the size position") {
  MjcfDocument document;
  WriteMjcf(hand_made::Mallet(), Target::kMujoco, SomeProvenance(), document);
  CHECK(document.text.substr(document.size_position, 13) == "  <worldbody>");
}

TEST_CASE("a document's memory is used again without a trace of the last object") {
  MjcfDocument reused;
  WriteMjcf(hand_made::Wedge(), Target::kScene, SomeProvenance(), reused);
  WriteMjcf(hand_made::Mallet(), Target::kMujoco, SomeProvenance(), reused);
  MjcfDocument fresh;
  WriteMjcf(hand_made::Mallet(), Target::kMujoco, SomeProvenance(), fresh);
  CHECK(reused.text == fresh.text);
  CHECK(reused.origins.size() == fresh.origins.size());
  CHECK(reused.size_position == fresh.size_position);
  CHECK(reused.lift == 0);
}

TEST_CASE("textures, materials and meshes are assets with relative files") {
  model::Object object = hand_made::Wedge();
  model::Texture texture;
  texture.name = "wedge_oak";
  texture.files.push_back({.file = "/somewhere/Oak.png", .output_file = "Oak.png"});
  texture.attributes = {hand_made::Word("type", spec::Applies::kBoth, "cube")};
  texture.mark = hand_made::Line(40);
  object.textures.push_back(texture);
  model::Material material;
  material.name = "wedge_wood";
  material.texture = 0;
  material.attributes = {hand_made::Numbers("shininess", spec::Applies::kBoth, {0.2})};
  material.mark = hand_made::Line(41);
  object.materials.push_back(material);
  auto mesh = std::make_unique<model::MeshAsset>();
  mesh->name = "wedge_knob";
  mesh->file = "/elsewhere/knob.obj";
  mesh->output_file = "knob.obj";
  mesh->scale = {1, 1, -2};
  object.meshes.push_back(std::move(mesh));

  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, SomeProvenance(), document);
  const std::size_t begin = document.text.find("  <asset>");
  const std::size_t end = document.text.find("  <worldbody>");
  CHECK(document.text.substr(begin, end - begin).find(R"(  <asset>
    <texture name="wedge_oak" type="cube" file="assets/Oak.png"/>
    <material name="wedge_wood" texture="wedge_oak" shininess="0.2"/>
    <mesh name="wedge_body" vertex=")") == 0);
  CHECK(document.text.find("    <mesh name=\"wedge_knob\" file=\"assets/knob.obj\" "
                           "scale=\"1 1 -2\"/>\n  </asset>\n") != std::string::npos);
  using Assets = decltype(document.assets);
  CHECK(document.assets == Assets{{"assets/Oak.png", "/somewhere/Oak.png"},
                                  {"assets/knob.obj", "/elsewhere/knob.obj"}});
  CHECK(document.Origin(5).line == 40);
  CHECK(document.Origin(6).line == 41);
  CHECK(document.Origin(7).line == 31);
}

TEST_CASE("an inline mesh states its triangles unless it is the hull of its vertices") {
  model::Object object = hand_made::Wedge();
  MjcfDocument document;
  WriteMjcf(object, Target::kMujoco, SomeProvenance(), document);
  CHECK(document.text.find(" face=\"") == std::string::npos);
  object.meshes[0]->is_hull = false;
  object.meshes[0]->mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  WriteMjcf(object, Target::kMujoco, SomeProvenance(), document);
  CHECK(document.text.find(" face=\"0 1 2 2 1 3\"/>") != std::string::npos);
}

TEST_CASE("what is only seen is written in micrometres, and its normals beside coordinates only") {
  model::Object object = hand_made::Wedge();
  MjcfDocument document;
  const auto text = [&] {
    WriteMjcf(object, Target::kMujoco, SomeProvenance(), document);
    const std::size_t at = document.text.find("<mesh name=\"wedge_body\"");
    return document.text.substr(at + 23, document.text.find('\n', at) - at - 23);
  };
  model::MeshAsset& asset = *object.meshes[0];
  asset.is_hull = false;
  asset.mesh.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.000123, 0}, {0, 0, -1.5}};
  asset.mesh.triangles = {{0, 1, 2}};
  asset.mesh.normals.assign(4, {0, 0.6, 0.8});
  CHECK(text() ==
        " vertex=\"0 0 0 0.1 0 0 0 0.000123 0 0 0 -1.5\""
        " normal=\"0 0.6 0.8 0 0.6 0.8 0 0.6 0.8 0 0.6 0.8\" face=\"0 1 2\"/>");
  asset.mesh.in_micrometres = true;
  CHECK(text() ==
        " scale=\"1e-06 1e-06 1e-06\" vertex=\"0 0 0 100000 0 0 0 123 0 0 0 -1500000\""
        " smoothnormal=\"true\" face=\"0 1 2\"/>");
  asset.mesh.texcoords.assign(4, {0.5, 1});
  CHECK(text() ==
        " scale=\"1e-06 1e-06 1e-06\" vertex=\"0 0 0 100000 0 0 0 123 0 0 0 -1500000\""
        " normal=\"0 0.6 0.8 0 0.6 0.8 0 0.6 0.8 0 0.6 0.8\""
        " texcoord=\"0.5 1 0.5 1 0.5 1 0.5 1\" face=\"0 1 2\"/>");
}

TEST_CASE("every target is found by its name") {
  for (const TargetRules& info : Targets()) CHECK(FindTarget(info.name) == info.target);
  CHECK_FALSE(FindTarget("robot"));
}

}  // namespace
}  // namespace mjforge::mjcf
