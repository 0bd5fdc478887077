#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "adapted.h"

namespace mjforge::mjcf {
namespace {

using namespace adapted;

TEST_CASE("hosts drop every section, one warning each") {
  model::Object object = Chest();
  Add(object, "option",
      {Made("option", "option", "", 20, {Numbers("timestep", Applies::kBoth, {0.001})})});
  Add(object, "contact",
      {Made("contact", "exclude", "", 21, {Text("body1", "object"), Text("body2", "lid")})});
  std::vector<model::Element> sensors;
  for (int i = 0; i < 7; ++i) {
    sensors.push_back(
        Made("sensor", "jointpos", "s" + std::to_string(i), 30, {Text("joint", "hinge")}));
  }
  Add(object, "sensor", std::move(sensors));
  const std::string start = "robosuite reads only the body and its assets: ";
  CHECK(Adapted(object, "robosuite") ==
        Said{"20: " + start + "'option' is dropped",
             "21: " + start + "1 element of 'contact' is dropped (exclude of 'chest' and 'lid')",
             "30: " + start +
                 "7 elements of 'sensor' are dropped ('s0', 's1', 's2', 's3', 's4' and 2 more)"});
  CHECK(object.sections.empty());
}

TEST_CASE("a texture whose sides the host would not find becomes one colour") {
  model::Object object = Chest();
  model::Texture& texture = object.textures.emplace_back();
  texture.name = "sky";
  texture.mark = Line(15);
  texture.files = {{"fileup", "up.png", "up.png"}, {"filedown", "down.png", "down.png"}};
  model::Texture& plain = object.textures.emplace_back();
  plain.name = "wood";
  plain.files = {{"file", "wood.png", "wood.png"}};
  CHECK(Adapted(object, "robosuite") ==
        Said{"15: robosuite reads the picture of a texture only from 'file': the sides of texture "
             "'sky' are dropped"});
  const pugi::xml_document file = Written(object, "robosuite");
  const pugi::xml_node sky = file.select_node("//texture[@name='sky']").node();
  CHECK(std::string(sky.attribute("builtin").value()) == "flat");
  CHECK_FALSE(sky.attribute("fileup"));
  CHECK(file.select_node("//texture[@name='wood'][@file='assets/wood.png']"));
}

TEST_CASE("for MJX what it does not implement is dropped, with what refers to it") {
  model::Object object = Chest();
  Add(object, "option",
      {Made("option", "option", "", 20,
            {Text("integrator", "implicit"), Text("solver", "CG"), Text("cone", "elliptic")})});
  Add(object, "contact",
      {Made("contact", "pair", "touch", 21,
            {Text("geom1", "base"), Numbers("margin", Applies::kBoth, {0.1}),
             Text("geom2", "plate")})});
  Add(object, "actuator",
      {Made("actuator", "adhesion", "glue", 22, {Text("body", "lid")}),
       Made("actuator", "motor", "motor", 23, {Text("joint", "hinge")}),
       Made("actuator", "general", "own", 24, {Text("joint", "hinge"), Text("dyntype", "user")})});
  Add(object, "sensor",
      {Made("sensor", "jointlimitpos", "limit", 25, {Text("joint", "hinge")}),
       Made("sensor", "actuatorfrc", "pull", 26, {Text("actuator", "glue")}),
       Made("sensor", "actuatorfrc", "turn", 27, {Text("actuator", "motor")})});
  CHECK(Adapted(object, "mjx") ==
        Said{"20: mjx has no integrator implicit: it is dropped from option",
             "21: mjx has no margin: it is dropped from pair 'touch'",
             "22: mjx does not have this kind of actuator: adhesion 'glue' is dropped",
             "24: mjx does not have this kind of actuator: general 'own' is dropped",
             "25: mjx does not have this kind of sensor: jointlimitpos 'limit' is dropped",
             "26: actuatorfrc 'pull' is dropped with 'glue', which it refers to"});
  REQUIRE(ElementsOf(object, "actuator").size() == 1);
  CHECK(ElementsOf(object, "actuator")[0].name == "motor");
  REQUIRE(ElementsOf(object, "sensor").size() == 1);
  CHECK(ElementsOf(object, "sensor")[0].name == "turn");
  CHECK(ElementsOf(object, "option")[0].attributes.size() == 2);
}

TEST_CASE("a section that has lost all its elements goes, too") {
  model::Object object = Chest();
  Add(object, "sensor", {Made("sensor", "user", "own", 25)});
  CHECK(Adapted(object, "mjx").size() == 1);
  CHECK(object.sections.empty());
}

}  // namespace
}  // namespace mjforge::mjcf
