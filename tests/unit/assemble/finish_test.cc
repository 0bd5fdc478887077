// Tests of bounds, mass and checks of the whole object.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

TEST_CASE("bounds are those of the parts that collide") {
  const Assembling thing(
      "parts:\n"
      "- {name: a, type: box, size: [1, 2, 3], pos: [0, 0, 1], role: collision}\n"
      "- {name: b, type: sphere, size: [1], pos: [3, 4, 0]}\n"
      "- {name: c, type: sphere, size: [50], role: visual}\n");
  const model::Bounds& bounds = thing.object().bounds;
  CHECK(bounds.aabb.min == Eigen::Vector3d(-1, -2, -2));
  CHECK(bounds.aabb.max == Eigen::Vector3d(4, 5, 4));
  CHECK(bounds.top_offset == 4);
  CHECK(bounds.bottom_offset == -2);
  CHECK(bounds.horizontal_radius == 6);
  CHECK(bounds.half_size() == Eigen::Vector3d(2.5, 3.5, 3));
}

TEST_CASE("where nothing collides the bounds are those of all parts") {
  const Assembling thing(
      "joints: none\nparts: [{name: c, type: sphere, size: [5], role: visual}]\n");
  CHECK(thing.object().bounds.horizontal_radius == 5);
}

TEST_CASE("the object's mass scales its parts") {
  const Assembling thing(
      "mass: 12\n"
      "parts:\n"
      "- {name: a, type: sphere, size: [1], mass: 1}\n"
      "- {name: b, type: sphere, size: [1], mass: 3, pos: [4, 0, 0]}\n");
  CHECK(thing.part("thing_a").mass == Approx(3));
  CHECK(thing.part("thing_b").mass == Approx(9));
  CHECK(thing.object().mass_properties.mass == Approx(12));
  CHECK(thing.object().mass_properties.p_FCm.isApprox(Eigen::Vector3d(3, 0, 0)));
  CHECK(thing.object().mass_properties.I_Cm_F(0, 0) == Approx(12 * 0.4));
  CHECK(thing.object().mass_properties.I_Cm_F(1, 1) == Approx(12 * 0.4 + 3 * 9 + 9 * 1));
}

TEST_CASE("an object without parts is an error") {
  CHECK(OnlyFinding("params: {n: 0}\n"
                    "parts: [{name: a, if: n > 0, type: sphere, size: [1]}]\n") ==
        "4:9 no part is left (every part is left out by its 'if' or 'for')");
}

TEST_CASE("an object that can move needs mass") {
  CHECK(OnlyFinding("parts: [{name: a, type: sphere, size: [1], role: visual}]\n") ==
        "3:9 object 'thing' can move but has no mass (give a part a mass, or write `joints: "
        "none`)");
}

TEST_CASE("a mass that no part can carry is an error") {
  CHECK(OnlyFinding("mass: 3\n"
                    "parts: [{name: a, type: sphere, size: [1], role: visual}]\n") ==
        "3:7 mass of object 'thing' cannot be reached: no part has mass");
}

TEST_CASE("a root without mass takes half of that of the first body fixed to it") {
  const Assembling thing(
      "bodies:\n"
      "- {name: sign, parts: [{name: s, type: sphere, size: [1], role: visual}]}\n"
      "- {name: base, parent: sign, pos: [0, 0, 2], parts: [{name: b, type: sphere, size: [1], "
      "mass: 3}]}\n"
      "- {name: rest, parts: [{name: r, type: sphere, size: [1], mass: 5}]}\n");
  const std::vector<model::Body>& bodies = thing.object().bodies;
  REQUIRE(bodies.size() == 4);
  CHECK(bodies[0].mass_properties.mass == 1.5);
  CHECK(bodies[0].mass_properties.p_FCm == Eigen::Vector3d(0, 0, 2));
  CHECK(bodies[0].mass_properties.I_Cm_F(0, 0) == Approx(0.4 * 1.5));
  CHECK(bodies[2].mass_properties.mass == 1.5);
  CHECK(bodies[3].mass_properties.mass == 5);
  CHECK(bodies[0].explicit_inertial);
  CHECK(bodies[2].explicit_inertial);
  CHECK_FALSE(bodies[3].explicit_inertial);
  CHECK(thing.object().mass_properties.mass == 8);
}

TEST_CASE(
    "a body that moves and has no mass takes it from what is fixed to it, not from beyond a "
    "joint") {
  const Assembling thing(
      "parts: [{name: p, type: sphere, size: [1]}]\n"
      "bodies:\n"
      "- {name: arm, joints: [{name: j, axis: [0, 0, 1]}], parts: []}\n"
      "- {name: far, parent: arm, joints: [{name: k, axis: [0, 0, 1]}],\n"
      "   parts: [{name: f, type: sphere, size: [1], mass: 7}]}\n"
      "- {name: hand, parent: arm, parts: [{name: h, type: sphere, size: [1], mass: 3}]}\n");
  const std::vector<model::Body>& bodies = thing.object().bodies;
  CHECK_FALSE(bodies[0].explicit_inertial);
  CHECK(bodies[1].mass_properties.mass == 1.5);
  CHECK(bodies[2].mass_properties.mass == 7);
  CHECK(bodies[3].mass_properties.mass == 1.5);
}

const std::string kDoor =
    "params: {is_open: {choice: [true, false]}}\n"
    "parts: [{name: p, type: sphere, size: 1}]\n"
    "bodies:\n"
    "- {name: left, pos: [3, 0, 0], parts: [{name: q, type: sphere, size: 1}],\n"
    "   joints: [{name: left_door}]}\n"
    "- {name: right, pos: [6, 0, 0], parts: [{name: r, type: sphere, size: 1}],\n"
    "   joints: [{name: right_door}, {name: latch, type: slide, if: is_open}]}\n"
    "- {name: 'leaf_${i}', for: {i: 'is_open ? 1 : 0'}, pos: [9, 0, 0],\n"
    "   parts: [{name: 's_${i}', type: sphere, size: 1}], joints: [{name: 'swing_${i}'}]}\n";

TEST_CASE("a pose in pictures names joints of the object") {
  const auto findings = [](const std::string& pose, std::uint64_t index = 0) {
    const Assembling thing(kDoor + "view: {pose: {" + pose + "}}\n", 1, index);
    CHECK_FALSE(thing.failed());  // a warning
    return thing.findings();
  };
  using Lines = std::vector<std::string>;
  CHECK(findings("left_door: 1, thing_right_door: 1") == Lines{});
  CHECK(findings("rigth_door: 1") ==
        Lines{"12:15 view: the object has no joint 'rigth_door' (did you mean 'right_door'?)"});
  CHECK(findings("left_door: 1, door: 1") ==
        Lines{"12:29 view: 'door' could be joint 'thing_left_door' or 'thing_right_door' "
              "(give its full name)"});
  CHECK(findings("left_door: 5cm") ==
        Lines{"12:15 view: joint 'left_door' is in rad, but this is in m"});
  const Assembling drawer(
      "parts: [{name: p, type: sphere, size: 1}]\nbodies: [{name: d, pos: [3, 0, 0],\n"
      "  parts: [{name: q, type: sphere, size: 1}], joints: [{name: pull, type: slide}]}]\n"
      "view: {pose: {pull: 5deg}}\n");
  CHECK(drawer.findings() == Lines{"6:15 view: joint 'pull' is in m, but this is in rad"});
  const Assembling free_one(
      "joints: free\nparts: [{name: p, type: sphere, size: 1}]\nview: {pose: {joint0: 1}}\n");
  CHECK(free_one.findings() == Lines{"5:15 view: the object has no joint 'joint0'"});
  for (std::uint64_t index = 0; index < 8; ++index)
    CHECK(findings("latch: 0, swing_0: 0", index) == Lines{});
}

}  // namespace
}  // namespace mjforge::assemble
