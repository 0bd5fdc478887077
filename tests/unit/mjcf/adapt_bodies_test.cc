#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "adapted.h"

namespace mjforge::mjcf {
namespace {

using namespace adapted;

TEST_CASE("hosts get the root in an unnamed body with sites at the bounds") {
  for (const char* target : kHosts) {
    CAPTURE(target);
    model::Object object = Chest();
    CHECK(Adapted(object, target) == Said{});
    REQUIRE(object.bodies.size() == 3);
    CHECK(object.bodies[0].parent == -1);
    CHECK(object.bodies[1].parent == 0);
    CHECK(object.bodies[2].parent == 1);
    const pugi::xml_document file = Written(object, target);
    const pugi::xml_node outer = file.select_node("/mujoco/worldbody/body").node();
    CHECK_FALSE(outer.attribute("name"));
    CHECK(outer.select_node("body[@name='object']/body[@name='lid']"));
    const auto pos = [&](const char* site) {
      const pugi::xml_node node = outer.find_child_by_attribute("site", "name", site);
      CHECK(std::string(node.attribute("rgba").value()) == "0 0 0 0");
      return std::string(node.attribute("pos").value());
    };
    CHECK(pos("bottom_site") == "0 0 -0.05");
    CHECK(pos("top_site") == "0 0 0.065");
    CHECK(pos("horizontal_radius_site") == "0.055 0.055 0");
  }
}

TEST_CASE("the host adds the root's free joint; other joints stay") {
  for (const char* target : kHosts) {
    model::Object object = Chest();
    model::Joint slide;
    slide.name = "slide";
    slide.type = "slide";
    object.bodies[0].joints.push_back(slide);
    CHECK(Adapted(object, target) == Said{});
    REQUIRE(object.bodies[1].joints.size() == 1);
    CHECK(object.bodies[1].joints[0].name == "slide");
    CHECK(object.bodies[2].joints[0].name == "hinge");
  }
}

TEST_CASE("what a free joint says beside its type is dropped with a warning") {
  model::Object object = Chest();
  object.bodies[0].joints[0].attributes = {Numbers("damping", Applies::kBoth, {0.1}),
                                           Numbers("armature", Applies::kBoth, {0.2})};
  CHECK(Adapted(object, "robosuite") ==
        Said{"2: robosuite adds the free joint itself: the attributes of joint 'joint0' are "
             "dropped (damping, armature)"});
  CHECK(object.bodies[1].joints.empty());
}

TEST_CASE("robocasa gets a box around the object that is no part of it") {
  model::Object object = Chest();
  object.bounds.aabb = {.min = {-0.02, -0.04, -0.05}, .max = {0.04, 0.04, 0.065}};
  CHECK(Adapted(object, "robocasa") == Said{});
  const pugi::xml_document file = Written(object, "robocasa");
  const pugi::xml_node box =
      file.select_node("//body[@name='object']/geom[@name='reg_bbox']").node();
  CHECK(std::string(box.attribute("type").value()) == "box");
  CHECK(std::string(box.attribute("pos").value()) == "0.01 0 0.0075");
  CHECK(std::string(box.attribute("size").value()) == "0.03 0.04 0.0575");
  CHECK(std::string(box.attribute("mass").value()) == "0");
  CHECK(std::string(box.attribute("contype").value()) == "0");
  CHECK(std::string(box.attribute("conaffinity").value()) == "0");
  CHECK(std::string(box.attribute("group").value()) == "1");
  CHECK(std::string(box.attribute("rgba").value()) == "0 1 0 0");
}

model::Region RegionOf(model::RegionType type, std::string site, std::uint32_t line) {
  model::Region region;
  region.type = type;
  region.site = std::move(site);
  region.half_size = {0.03, 0.03};
  region.X_BR.p = {0, 0, 0.005};
  region.mark = Line(line);
  return region;
}

TEST_CASE("robocasa gets the spaces above regions") {
  using model::RegionType;
  model::Object object = Chest();
  object.bodies[0].regions = {RegionOf(RegionType::kBox, "inside", 20)};
  object.bodies[0].regions[0].height = 0.05;
  object.bodies[1].regions = {RegionOf(RegionType::kDisc, "lid_surface", 21)};
  CHECK(Adapted(object, "robocasa") == Said{});
  const pugi::xml_document file = Written(object, "robocasa");
  const auto attribute = [&](const char* geom, const char* key) {
    const std::string path = std::string("//geom[@name='") + geom + "']";
    return std::string(file.select_node(path.c_str()).node().attribute(key).value());
  };
  CHECK(attribute("reg_int", "type") == "box");
  CHECK(attribute("reg_int", "size") == "0.03 0.03 0.025");
  CHECK(attribute("reg_int", "pos") == "0 0 0.03");
  CHECK(attribute("reg_int", "rgba") == "0 1 0 0");
  CHECK(attribute("reg_lid_surface", "type") == "cylinder");
  CHECK(attribute("reg_lid_surface", "size") == "0.03 0.25");
  CHECK(attribute("reg_lid_surface", "contype") == "0");
}

TEST_CASE("two regions of one name in robocasa are reported") {
  model::Object object = Chest();
  object.bodies[0].regions = {RegionOf(model::RegionType::kBox, "bbox", 20),
                              RegionOf(model::RegionType::kBox, "int", 21),
                              RegionOf(model::RegionType::kBox, "inside", 22)};
  CHECK(Adapted(object, "robocasa") ==
        Said{"20 error: region 'bbox' becomes a second region 'bbox' of robocasa",
             "22 error: region 'inside' becomes a second region 'int' of robocasa"});
  CHECK(Adapted(object = Chest(), "robosuite") == Said{});
}

TEST_CASE("a camera that looks at the root is dropped where the root is renamed") {
  model::Object object = Chest();
  model::Element camera;
  camera.tag = "camera";
  camera.name = "eye";
  camera.mark = Line(16);
  camera.attributes = {{"target", Applies::kBoth, {}, "object", "body"}};
  object.bodies[1].elements.push_back(camera);
  camera.name = "other_eye";
  camera.attributes[0].text = "lid";
  object.bodies[1].elements.push_back(camera);
  CHECK(Adapted(object, "robosuite") ==
        Said{"16: robosuite renames the root body: camera 'eye', which looks at it, is dropped"});
  REQUIRE(object.bodies[2].elements.size() == 1);
  CHECK(object.bodies[2].elements[0].name == "other_eye");
}

}  // namespace
}  // namespace mjforge::mjcf
