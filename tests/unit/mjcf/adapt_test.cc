#include <catch2/catch.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "adapted.h"

namespace mjforge::mjcf {
namespace {

using namespace adapted;

TEST_CASE("for mujoco and scene an object stays as it is") {
  for (const char* target : {"mujoco", "scene"}) {
    model::Object object = Chest();
    Add(object, "contact", {Made("contact", "exclude", "", 9)});
    object.bodies[0].parts[0].attributes = {Numbers("group", Applies::kBoth, {5})};
    CHECK(Adapted(object, target) == Said{});
    CHECK(object.bodies.size() == 2);
    CHECK(object.bodies[0].joints.size() == 1);
    CHECK(object.bodies[0].parts.size() == 1);
    CHECK(object.bodies[0].parts[0].attributes.size() == 1);
    CHECK(object.sections.size() == 1);
  }
}

}  // namespace
}  // namespace mjforge::mjcf
