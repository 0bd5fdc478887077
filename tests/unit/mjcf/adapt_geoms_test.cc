#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "adapted.h"

namespace mjforge::mjcf {
namespace {

using namespace adapted;

TEST_CASE("hosts tell geoms by their group, whatever the spec says of it") {
  for (const char* target : kHosts) {
    CAPTURE(target);
    model::Object object = Chest();
    std::vector<model::Part>& parts = object.bodies[0].parts;
    parts.push_back(parts[0]);
    parts.back().name = "look";
    parts.back().role = Role::kVisual;
    parts.back().attributes = {
        Numbers("group", Applies::kBoth, {1})};  // equals the group of the host
    parts[0].attributes = {Numbers("group", Applies::kBoth, {2})};
    object.bodies[1].parts[0].attributes = {Numbers("group", Applies::kVisual, {4})};
    CHECK(Adapted(object, target) ==
          Said{"3: " + std::string(target) +
               " tells collision geoms (0) from visual ones (1) by their group: 'group' of base, "
               "plate is overridden"});
    const pugi::xml_document file = Written(object, target);
    const auto group = [&](const std::string& geom) {
      const std::string path = "//geom[@name='" + geom + "']";
      return file.select_node(path.c_str()).node().attribute("group").as_int(-1);
    };
    CHECK(group("base") == 0);
    CHECK(group("base_vis") == 1);
    CHECK(group("look_vis") == 1);
    CHECK(group("plate") == 0);
    CHECK(group("plate_vis") == 1);
  }
}

TEST_CASE("an attached geom gets the group of its role without a word") {
  model::Object object = Chest();
  model::Part& part = object.bodies[1].parts[0];
  part.as_is = true;
  part.role = Role::kVisual;
  part.attributes = {Numbers("contype", Applies::kBoth, {0}),
                     Numbers("group", Applies::kBoth, {2})};
  CHECK(Adapted(object, "robosuite") == Said{});
  const auto file = Written(object, "robosuite");
  const pugi::xml_node geom = file.select_node("//geom[@name='plate']").node();
  CHECK(geom.attribute("group").as_int() == 1);
}

TEST_CASE("robosuite's collision geoms show what the visual ones show") {
  model::Object object = Chest();
  object.bodies[0].parts[0].attributes = {Numbers("rgba", Applies::kVisual, {0, 0, 1, 1}),
                                          Numbers("friction", Applies::kCollision, {2})};
  CHECK(Adapted(object, "robosuite") == Said{});
  const pugi::xml_document file = Written(object, "robosuite");
  const pugi::xml_node collision = file.select_node("//geom[@name='base']").node();
  CHECK(std::string(collision.attribute("rgba").value()) == "0 0 1 1");
  CHECK(std::string(collision.attribute("friction").value()) == "2");
  CHECK(std::string(collision.attribute("density").value()) == "500");
  const pugi::xml_node visual = file.select_node("//geom[@name='base_vis']").node();
  CHECK(std::string(visual.attribute("rgba").value()) == "0 0 1 1");
  CHECK(std::string(visual.attribute("mass").value()) == "0");
  CHECK_FALSE(visual.attribute("friction"));
  const pugi::xml_node plate = file.select_node("//geom[@name='plate']").node();
  CHECK(std::string(plate.attribute("rgba").value()) == "0.5 0.5 0.5 1");
}

TEST_CASE("robocasa gets masses, three-number spheres and always an asset element") {
  model::Object object = Chest();
  object.bodies[0].parts.push_back(
      hand_made::Solid("ball", GeomType::kSphere, {0.02, 0, 0}, {}, 4));
  const double mass = object.bodies[0].parts[1].mass;
  CHECK(Adapted(object, "robocasa") == Said{});
  const pugi::xml_document file = Written(object, "robocasa");
  const pugi::xml_node ball = file.select_node("//geom[@name='ball']").node();
  CHECK(std::string(ball.attribute("size").value()) == "0.02 0.02 0.02");
  CHECK(ball.attribute("mass").as_double() == Approx(mass));
  CHECK(file.select_nodes("//geom[@density]").empty());
  CHECK(file.select_node("/mujoco/asset"));
}

TEST_CASE("for MJX margins are dropped, with a warning where they are not zero") {
  model::Object object = Chest();
  object.bodies[0].parts[0].attributes = {Numbers("margin", Applies::kCollision, {0.001}),
                                          Numbers("friction", Applies::kCollision, {2})};
  object.bodies[1].parts[0].attributes = {Numbers("gap", Applies::kCollision, {0})};
  CHECK(Adapted(object, "mjx") == Said{"3: mjx does not support margins when meshes collide: "
                                       "'margin' and 'gap' of base are dropped"});
  CHECK(object.bodies[0].parts[0].attributes.size() == 1);
}

}  // namespace
}  // namespace mjforge::mjcf
