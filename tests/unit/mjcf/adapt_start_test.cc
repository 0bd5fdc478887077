#include <catch2/catch.hpp>
#include <optional>
#include <string>

#include "adapted.h"

namespace mjforge::mjcf {
namespace {

using namespace adapted;

// Returns a chest whose lid starts open; with a free root unless `is_fixed`.
model::Object OpenChest(std::optional<model::StartForm> form, bool is_fixed = false) {
  model::Object object = Chest();
  object.start_form = form;
  if (is_fixed) object.bodies[0].joints.clear();
  object.bodies[1].joints[0].start = {0.5};
  return object;
}

bool HasStartAtZero(const pugi::xml_document& file) {
  return !file.select_nodes("//joint[@name='hinge'][@ref='0.5']").empty();
}
bool HasKeyframe(const pugi::xml_document& file) { return !file.select_nodes("//key").empty(); }

TEST_CASE("an object with a free or a placed body starts at zero, others in a keyframe") {
  for (const char* target : {"mujoco", "scene", "mjx"}) {
    CAPTURE(target);
    model::Object free = OpenChest({});
    CHECK(Adapted(free, target) == Said{});
    CHECK(HasStartAtZero(Written(free, target)));
    // mjlab reads these files and sets joints to 0 unless there is a keyframe.
    CHECK(HasKeyframe(Written(free, target)) == (std::string(target) == "mujoco"));
    model::Object fixed = OpenChest({}, /*is_fixed=*/true);
    CHECK(Adapted(fixed, target) == Said{});
    CHECK_FALSE(HasStartAtZero(Written(fixed, target)));
    CHECK(HasKeyframe(Written(fixed, target)));
    model::Object placed = OpenChest({}, /*is_fixed=*/true);
    placed.bodies[1].place_name = "chest.top";
    CHECK(Adapted(placed, target) == Said{});
    CHECK(HasStartAtZero(Written(placed, target)));
  }
}

TEST_CASE("the spec decides where the start is") {
  model::Object keyframe = OpenChest(model::StartForm::kKeyframe);
  CHECK(Adapted(keyframe, "mujoco") == Said{});
  CHECK_FALSE(HasStartAtZero(Written(keyframe, "mujoco")));
  CHECK(HasKeyframe(Written(keyframe, "mujoco")));
  model::Object zero = OpenChest(model::StartForm::kZero, /*is_fixed=*/true);
  CHECK(Adapted(zero, "scene") == Said{});
  CHECK(HasStartAtZero(Written(zero, "scene")));
}

TEST_CASE("hosts without keyframes get the start at zero, unless the spec wants a keyframe") {
  for (const char* target : kHosts) {
    CAPTURE(target);
    model::Object object = OpenChest({}, /*is_fixed=*/true);
    CHECK(Adapted(object, target) == Said{});
    CHECK(HasStartAtZero(Written(object, target)));
    CHECK_FALSE(HasKeyframe(Written(object, target)));
    model::Object dropped = OpenChest(model::StartForm::kKeyframe);
    CHECK(Adapted(dropped, target) == Said{"6: " + std::string(target) +
                                           " has no keyframes in objects: the pose of joint "
                                           "'hinge' is dropped"});
    CHECK_FALSE(HasStartAtZero(Written(dropped, target)));
  }
}

TEST_CASE("velocities and setpoints are in a keyframe even if the start is at zero") {
  for (const char* target : {"mujoco", "scene"}) {
    model::Object object = OpenChest({});
    object.bodies[1].joints[0].start_velocity = {2};
    Add(object, "actuator", {Made("actuator", "position", "servo", 9, {Text("joint", "hinge")})});
    object.setpoints.push_back({.actuator = "servo", .ctrl = 0.5, .act = {}, .mark = {}});
    CHECK(Adapted(object, target) ==
          Said{"6: joint 'hinge' has no velocity in the zero configuration",
               "9: a reset sets actuator 'servo' to 0, not to its setpoint"});
    const pugi::xml_document file = Written(object, target);
    CHECK(HasStartAtZero(file));
    CHECK(file.select_node("//key[@qvel='0 0 0 0 0 0 2'][@ctrl='0.5']"));
  }
  model::Object object = OpenChest({});
  object.bodies[1].joints[0].start_velocity = {2};
  CHECK(Adapted(object, "robosuite") ==
        Said{"6: robosuite has no keyframes in objects: the velocity of joint 'hinge' is dropped"});
}

TEST_CASE("a start that moves no joint has the same warnings of velocities and setpoints") {
  model::Object object = Chest();
  object.bodies[0].joints[0].start_velocity = {1, 0, 0, 0, 0, 2};
  Add(object, "actuator", {Made("actuator", "motor", "motor", 9, {Text("joint", "hinge")})});
  object.setpoints.push_back({.actuator = "motor", .ctrl = 0.5, .act = {}, .mark = {}});
  CHECK(Adapted(object, "mujoco") ==
        Said{"2: joint 'joint0' has no velocity in the zero configuration",
             "9: a reset sets actuator 'motor' to 0, not to its setpoint"});
  CHECK(HasKeyframe(Written(object, "mujoco")));
}

TEST_CASE("a velocity of 0 is no velocity") {
  model::Object object = OpenChest(model::StartForm::kZero, /*is_fixed=*/true);
  object.bodies[1].joints[0].start_velocity = {0};
  CHECK(Adapted(object, "scene") == Said{});
  CHECK_FALSE(HasKeyframe(Written(object, "scene")));
  object.bodies[1].joints[0].start_velocity = {0};
  CHECK(Adapted(object, "robosuite") == Said{});
}

TEST_CASE("an obstacle is an error if the spec wants the start at zero, otherwise a warning") {
  const auto with_obstacle = [](std::optional<model::StartForm> form) {
    model::Object object = OpenChest(form);
    object.bodies[1].joints[0].attributes.push_back(
        Numbers("springdamper", Applies::kBoth, {0.1, 1}));
    return object;
  };
  model::Object asked = with_obstacle(model::StartForm::kZero);
  CHECK(Adapted(asked, "mujoco") ==
        Said{"6 error: the start cannot be the zero configuration: `springdamper` of joint 'hinge' "
             "depends on the inertia at zero"});
  model::Object usual = with_obstacle({});
  CHECK(Adapted(usual, "mujoco") ==
        Said{"6: the start is only a keyframe: `springdamper` of joint 'hinge' depends on the "
             "inertia at zero"});
  CHECK_FALSE(HasStartAtZero(Written(usual, "mujoco")));
  CHECK(HasKeyframe(Written(usual, "mujoco")));
}

}  // namespace
}  // namespace mjforge::mjcf
