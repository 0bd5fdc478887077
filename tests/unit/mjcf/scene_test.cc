#include <catch2/catch.hpp>
#include <pugixml.hpp>

#include "hand_made.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {
namespace {

pugi::xml_document Scene(const model::Object& object) {
  MjcfDocument document;
  WriteMjcf(object, Target::kScene, {}, document);
  pugi::xml_document parsed;
  REQUIRE(parsed.load_buffer(document.text.data(), document.text.size()));
  CHECK(document.size_position == std::string::npos);
  return parsed;
}

TEST_CASE("a scene lifts the object onto its floor") {
  const model::Object object = hand_made::Mallet();
  MjcfDocument document;
  WriteMjcf(object, Target::kScene, {}, document);
  CHECK(document.lift == 0.1);
  CHECK(document.text.find("<body name=\"mallet_root\" pos=\"0 0 0.1\">") != std::string::npos);
}

TEST_CASE("a scene has floor, light and camera under names no object can have") {
  const pugi::xml_document scene = Scene(hand_made::Mallet());
  CHECK(scene.select_node("/mujoco/worldbody/geom[@type='plane'][@name='scene-floor']"));
  CHECK(scene.select_node("/mujoco/worldbody/light[@name='scene-light']"));
  CHECK(scene.select_node("/mujoco/worldbody/camera[@name='scene-camera']"));
  CHECK(scene.select_node("/mujoco/asset/texture[@name='scene-floor']"));
  CHECK(scene.select_node("/mujoco/asset/material[@name='scene-floor']"));
}

}  // namespace
}  // namespace mjforge::mjcf
