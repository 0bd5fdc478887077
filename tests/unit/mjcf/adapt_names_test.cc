#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "adapted.h"

namespace mjforge::mjcf {
namespace {

using namespace adapted;

TEST_CASE("names that would clash with the host's are errors") {
  model::Object object = Chest();
  object.bodies[0].parts[0].name = "chest_base";
  object.bodies[1].name = "main";
  object.bodies[1].joints[0].name = "joint0";
  object.bodies[1].sites.emplace_back().name = "top_site";
  object.bodies[1].sites[0].mark = Line(8);
  CHECK(Adapted(object, "robosuite") ==
        Said{"3 error: part 'chest_base' begins with the object's name: robosuite adds the prefix "
             "'chest_' only to names that lack it",
             "5 error: body 'main' has the name of a body that robosuite adds itself",
             "6 error: joint 'joint0' has the name of a joint that robosuite adds itself",
             "8 error: site 'top_site' has the name of a site that robosuite adds itself"});
}

TEST_CASE("a part beside one whose visual copy robosuite would name so is an error") {
  model::Object object = Chest();
  object.bodies[1].parts[0].name = "base_visual";
  CHECK(Adapted(object, "robosuite") == Said{"7 error: part 'base_visual' has the name of the "
                                             "visual copy of 'base' that robosuite makes"});
  object = Chest();
  object.bodies[1].parts[0].name = "base_visual";
  CHECK(Adapted(object, "robocasa") == Said{});
  object = Chest();
  object.bodies[1].parts[0].name = "base_visual";
  object.bodies[1].parts[0].role = Role::kVisual;  // written as base_visual_vis
  CHECK(Adapted(object, "robosuite") == Said{});
}

TEST_CASE("a part that robocasa would take for a region is an error") {
  model::Object object = Chest();
  object.bodies[1].parts[0].name = "reg_bbox";
  CHECK(Adapted(object, "robocasa") ==
        Said{"7 error: part 'reg_bbox' would become a region: robocasa treats every geom as one if "
             "its name begins with 'reg_'"});
  object = Chest();
  object.bodies[1].parts[0].name = "reg_bbox";
  CHECK(Adapted(object, "robosuite") == Said{});
}

}  // namespace
}  // namespace mjforge::mjcf
