// Tests of properties that need all bodies: of subtrees, positions of sites, torques of joints.

#include <cmath>

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

double AttributeOf(const model::Object& object, const std::string& joint, const char* attribute) {
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& each : body.joints) {
      if (each.name != joint) continue;
      const model::Attribute* found = model::FindAttribute(each.attributes, attribute);
      return found == nullptr ? NAN : found->numbers.front();
    }
  }
  FAIL("no joint " << joint);
  return NAN;
}

// An arm along x of two balls of 1 kg and 2 kg, 0.5 m and 0.8 m from the shoulder; the elbow is at
// 0.5 m. `mass` may have the mass of the whole.
std::string Arm(const std::string& upper_joint, const std::string& lower_joint,
                const std::string& mass = "") {
  return mass +
         "joints: none\n"
         "bodies:\n"
         "- name: upper\n"
         "  parts: [{name: a, type: sphere, size: 1cm, mass: 1, pos: [0.5, 0, 0]}]\n"
         "  joints: [{name: shoulder, axis: [0, 2, 0], " +
         upper_joint +
         "}]\n"
         "- name: lower\n"
         "  parent: upper\n"
         "  pos: [0.5, 0, 0]\n"
         "  parts: [{name: b, type: sphere, size: 1cm, mass: 2, pos: [0.3, 0, 0]}]\n"
         "  joints: [{name: elbow, axis: [0, 1, 0], " +
         lower_joint + "}]\n";
}

}  // namespace

TEST_CASE("torque() is the weight of all that hangs from a joint times its distance") {
  const Assembling arm(Arm("frictionloss: torque(shoulder), damping: torque(elbow) / 1Nm",
                           "frictionloss: 1.5 * torque(elbow)"));
  CHECK(AttributeOf(arm.object(), "thing_shoulder", "frictionloss") ==
        Approx(9.81 * (1 * 0.5 + 2 * 0.8)));
  CHECK(AttributeOf(arm.object(), "thing_shoulder", "damping") == Approx(9.81 * 2 * 0.3));
  CHECK(AttributeOf(arm.object(), "thing_elbow", "frictionloss") == Approx(1.5 * 9.81 * 2 * 0.3));
}

TEST_CASE("torque() has the masses that the spec's mass gives") {
  const Assembling arm(Arm("frictionloss: torque(shoulder)", "", "mass: 6\n"));
  CHECK(AttributeOf(arm.object(), "thing_shoulder", "frictionloss") ==
        Approx(2 * 9.81 * (1 * 0.5 + 2 * 0.8)));
}

TEST_CASE("torque() of a hinge ignores what is along its axis, of a ball joint it does not") {
  const std::string parts =
      "parts: [{name: a, type: sphere, size: 1cm, mass: 1, pos: [0.3, 0, 0.4]}]\n"
      "joints: [{name: j, pos: [0, 0, 0], frictionloss: torque(j), ";
  CHECK(AttributeOf(Assembling(parts + "axis: [0, 0, 1]}]\n").object(), "thing_j",
                    "frictionloss") == Approx(9.81 * 0.3));
  CHECK(AttributeOf(Assembling(parts + "type: ball}]\n").object(), "thing_j", "frictionloss") ==
        Approx(9.81 * 0.5));
}

TEST_CASE("each body of a loop has its own values of what its joints use") {
  const Assembling row(
      "joints: none\n"
      "bodies:\n"
      "- {name: base, parts: [{name: g, type: sphere, size: 1}]}\n"
      "- name: 'flap_${i}'\n"
      "  for: {i: 3}\n"
      "  let: {far: 0.1 * (i + 1)}\n"
      "  if: i != 1\n"
      "  parts: [{name: 'p_${i}', type: sphere, size: 1cm, mass: 1, pos: [far, 0, 0]}]\n"
      "  joints: [{name: 'h_${i}', axis: [0, 1, 0], damping: far, stiffness: base.mass / 1kg}]\n");
  CHECK(AttributeOf(row.object(), "thing_h_0", "damping") == Approx(0.1));
  CHECK(AttributeOf(row.object(), "thing_h_2", "damping") == Approx(0.3));
  CHECK(AttributeOf(row.object(), "thing_h_2", "stiffness") > 0);
}

TEST_CASE("a condition that changes with the mass of the whole leaves each joint at its body") {
  const Assembling row(
      "mass: 0.5\n"
      "joints: none\n"
      "bodies:\n"
      "- {name: a, parts: [{name: g, type: sphere, size: 10cm, mass: 1}]}\n"
      "- name: 'b_${i}'\n"
      "  for: {i: 4}\n"
      "  if: a.mass < 0.5 or i == 3 or i == 1\n"
      "  parts: [{name: 'p_${i}', type: sphere, size: 1cm, mass: 1}]\n"
      "  joints: [{name: 'j_${i}', axis: [0, 1, 0], armature: i + 1}]\n");
  REQUIRE(row.object().bodies.size() == 4);
  CHECK(row.object().bodies[2].joints.at(0).name == "thing_j_1");
  CHECK(row.object().bodies[3].joints.at(0).name == "thing_j_3");
  CHECK(AttributeOf(row.object(), "thing_j_3", "armature") == 4);
}

TEST_CASE("torque() follows the type of the defaults, and a thread has none") {
  const std::string part = "parts: [{name: a, type: sphere, size: 1cm, mass: 1}]\n";
  CHECK(OnlyFinding("defaults: {joint: {type: slide}}\n" + part +
                    "joints: [{name: j, armature: torque(j) / 1Nm}]\n")
            .find("no torque of a joint 'j' is known here") != std::string::npos);
  CHECK(OnlyFinding(part + "joints: [{name: j, armature: torque(j) / 1Nm, "
                           "screw: {axis: [1, 0, 0], lead: 1mm, turns: 3}}]\n")
            .find("no torque of a joint 'j' is known here") != std::string::npos);
}

TEST_CASE("an axis without a direction is reported once, although torque() needs it") {
  CHECK(OnlyFinding("params: {z: 0}\n"
                    "parts: [{name: a, type: sphere, size: 1cm}]\n"
                    "joints: [{name: j, axis: [0, 0, z], armature: torque(j) / 1Nm}]\n")
            .find("axis of joint 'j' is zero") != std::string::npos);
}

TEST_CASE("a chain has the subtree properties of its first link") {
  const Assembling rope(
      "joints: none\n"
      "bodies:\n"
      "- name: rope\n"
      "  chain: {links: 3, length: 30cm}\n"
      "  parts: [{name: l, type: capsule, size: [5mm, 4cm], pos: [0, 0, -5cm], mass: 2}]\n"
      "  joints: [{name: top, armature: rope.subtree_mass / 1kg}]\n");
  CHECK(AttributeOf(rope.object(), "thing_top", "armature") == Approx(6));
}

TEST_CASE("a parameter of a nested spec keeps its name beside a site") {
  const TemporaryFolder folder;
  folder.Write("inner.yaml",
               "mjforge: 1\nname: inner\nparams: {pos: [1, 2, 3]}\n"
               "parts: [{name: g, type: sphere, size: 1cm, pos: pos}]\n");
  const Assembling thing(
      "joints: none\n"
      "sites: [{name: a, pos: [0.2, 0, 0]}]\n"
      "bodies:\n"
      "- {name: a, spec: inner.yaml, joints: [{name: j, armature: a.pos.x}]}\n",
      1, 0, folder.path());
  CHECK(AttributeOf(thing.object(), "thing_j", "armature") == 1);
}

TEST_CASE("subtree properties are those of a body and of all below it, and of no other") {
  const Assembling thing(
      "joints: none\n"
      "bodies:\n"
      "- name: a\n"
      "  parts: [{name: ga, type: box, size: [1, 1, 1], mass: 1}]\n"
      "  joints: [{name: j, damping: a.subtree_mass / 1kg, armature: a.subtree_top / 1m, "
      "stiffness: a.mass / 1kg}]\n"
      "- {name: other, parts: [{name: go, type: box, size: [1, 1, 9], mass: 8}]}\n"
      "- {name: b, parent: a, pos: [0, 0, 2], parts: [{name: gb, type: box, size: [1, 1, 3], mass: "
      "4}]}\n");
  CHECK(AttributeOf(thing.object(), "thing_j", "damping") == Approx(5));
  CHECK(AttributeOf(thing.object(), "thing_j", "armature") == Approx(5));
  CHECK(AttributeOf(thing.object(), "thing_j", "stiffness") == Approx(1));
}

TEST_CASE("positions of sites are in the frame of the spec, with joints at zero") {
  const Assembling thing(
      "joints: none\n"
      "sites: [{name: pin, pos: [0, 0, 1]}]\n"
      "bodies:\n"
      "- name: a\n"
      "  pos: [0, 0, 2]\n"
      "  euler: [0, 90deg, 0]\n"
      "  parts: [{name: g, type: sphere, size: 1}]\n"
      "  sites: [{name: tip, pos: [0, 0, 3]}]\n"
      "  joints: [{name: j, damping: tip.pos.x / 1m, armature: tip.pos.z / 1m,\n"
      "    stiffness: 'distance(pin, tip) / 1m', frictionloss: 'distance(tip, tip) / 1m'}]\n");
  CHECK(AttributeOf(thing.object(), "thing_j", "damping") == Approx(3));
  CHECK(AttributeOf(thing.object(), "thing_j", "armature") == Approx(2));
  CHECK(AttributeOf(thing.object(), "thing_j", "stiffness") == Approx(std::sqrt(10.0)));
  CHECK(AttributeOf(thing.object(), "thing_j", "frictionloss") == 0);
}

TEST_CASE("expectations and sections read torques and distances") {
  const std::string arm = Arm("", "") +
                          "sites: [{name: pin, pos: [1, 2, 2]}, {name: zero}]\n"
                          "mjcf: {custom: [{numeric: {name: n, data: torque(shoulder)}}]}\n"
                          "expect: [\"abs(distance(pin, zero) - 3) < 1e-9\", "
                          "torque(elbow) < torque(shoulder)]\n";
  const Assembling thing(arm);
  CHECK(thing.object().sections.at(0).elements.at(0).attributes.at(0).numbers.front() ==
        Approx(9.81 * 2.1));
  CHECK(Assembling(arm + "  - torque(elbow) > torque(shoulder)\n").failed());
}

TEST_CASE("what is left out has no torque and no position") {
  const std::string one =
      "parts: [{name: g, type: sphere, size: 1}]\n"
      "sites: [{name: pin, if: 'false'}]\n"
      "joints: [{name: a, frictionloss: torque(b)}, {name: b, if: 'false'}, "
      "{name: c, damping: pin.pos.x / 1m}]\n";
  CHECK(Assembling(one).findings() ==
        std::vector<std::string>{
            "5:34 expression 'torque(b)' uses 'torque(b)', which has no value in this variant "
            "(it was left out by 'if' or 'fewer', or is placed later)"});
}

}  // namespace mjforge::assemble
