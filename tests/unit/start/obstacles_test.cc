#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "started.h"

namespace mjforge::start {
namespace {

using Lines = std::vector<std::string>;

std::string Mechanism(const std::string& ball, const std::string& pose) {
  return "joints: none\n"
         "parts: [{name: base, type: box, size: [1, 1, 1]}]\n"
         "sites: [{name: hook, pos: [4, 0, 0]}]\n"
         "bodies:\n"
         "  - name: arm\n"
         "    joints: [{name: b, type: ball" +
         ball +
         "}]\n"
         "    parts: [{name: bar, type: sphere, size: 1, role: visual, mass: 1}]\n"
         "    sites: [{name: tip, pos: [3, 0, 0]}]\n"
         "pose: {b: " +
         pose + "}\n";
}
constexpr const char* kTurned = "[1, 0.1, 0, 0]";
constexpr const char* kWrapped =
    ", children: [{site: {site: hook}}, {geom: {geom: bar_vis}}, {site: {site: tip}}]}}]\n";

TEST_CASE("range and spring of a turned ball joint are obstacles") {
  CHECK(Obstacles(Mechanism(", range: [0, 1], stiffness: 2", kTurned)) ==
        Lines{"8: the range of ball joint 'b' is measured from its zero",
              "8: the spring of ball joint 'b' is measured from its zero"});
  CHECK(Obstacles(Mechanism(", range: [0, 1], stiffness: 2", "[1, 0, 0, 0]")).empty());
}

TEST_CASE("actuators and sensors of a turned ball joint are obstacles") {
  const std::string sections =
      "mjcf:\n"
      "  actuator: [{motor: {name: push, joint: b}}, {motor: {name: twist, jointinparent: b}}]\n"
      "  sensor: [{ballquat: {name: turn, joint: b}}, {ballangvel: {name: spin, joint: b}}]\n";
  CHECK(Obstacles(Mechanism("", kTurned) + sections) ==
        Lines{"13: actuator 'push' of ball joint 'b' is measured from its zero",
              "13: actuator 'twist' of ball joint 'b' is measured from its zero",
              "14: sensor 'turn' of ball joint 'b' is measured from its zero"});
}

TEST_CASE("numbers that only MuJoCo computes at zero are obstacles") {
  const std::string sections =
      "mjcf:\n"
      "  tendon: [{spatial: {name: rope, stiffness: 2" +
      std::string(kWrapped) +
      "  equality: [{tendon: {name: tie, tendon1: rope}}]\n"
      "  actuator:\n"
      "    - {muscle: {name: weak, tendon: rope}}\n"
      "    - {muscle: {name: strong, tendon: rope, force: 3, lengthrange: [1, 2]}}\n"
      "    - {general: {name: own, tendon: rope, gaintype: muscle, gainprm: [1, 2, -1]}}\n";
  CHECK(Obstacles(Mechanism("", kTurned) + sections) ==
        Lines{"14: equality 'tie' measures tendon 'rope' from zero, and only MuJoCo computes the "
              "length of a tendon around a geom",
              "13: the spring of tendon 'rope' is at rest at zero, and only MuJoCo computes the "
              "length of a tendon around a geom (give its `springlength`)",
              "18: the force of muscle 'own' depends on the inertia at zero (give the force in its "
              "parameters)",
              "18: MuJoCo computes the range of lengths of muscle 'own' from zero (give its "
              "`lengthrange`)",
              "16: the force of muscle 'weak' depends on the inertia at zero (give its `force`)",
              "16: MuJoCo computes the range of lengths of muscle 'weak' from zero (give its "
              "`lengthrange`)"});
  CHECK(Obstacles(Mechanism("", "[1, 0, 0, 0]") + sections).empty());
}

TEST_CASE("a spring and a damper computed from the inertia are an obstacle") {
  CHECK(Obstacles(Mechanism(", springdamper: [0.1, 1]", kTurned)) ==
        Lines{"8: `springdamper` of joint 'b' depends on the inertia at zero (give its "
              "`stiffness` and `damping`)"});
}

}  // namespace
}  // namespace mjforge::start
