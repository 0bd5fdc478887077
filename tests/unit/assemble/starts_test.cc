// Tests of the start state: `pose:` as a mapping and as a list, `start:`, free bodies, setpoints
// and equalities.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

const std::string kChain =
    "joints: none\n"
    "parts: [{name: p, type: sphere, size: 1}]\n"
    "bodies:\n"
    "- {name: \"seg_${i}\", for: {i: 3}, pos: [\"2 * i + 2\", 0, 0],\n"
    "   joints: [{name: \"seg_${i}_hinge\", range: [-2, 2]}],\n"
    "   parts: [{name: \"q_${i}\", type: sphere, size: 1}]}\n";

std::vector<sample::Numbers> StartsOf(const Assembling& thing) {
  std::vector<sample::Numbers> starts;
  for (const model::Body& body : thing.object().bodies) {
    for (const model::Joint& joint : body.joints) starts.push_back(joint.start);
  }
  return starts;
}

TEST_CASE("an entry of pose is repeated, with conditional text and local values") {
  const Assembling thing(kChain +
                         "pose:\n"
                         "- {joint: \"seg_${i}_hinge\", for: {i: 3}, let: {turn: 10deg * i},\n"
                         "   if: i > 0, value: turn}\n");
  const auto starts = StartsOf(thing);
  REQUIRE(starts.size() == 3);
  CHECK(starts[0].empty());
  CHECK(starts[1][0] == Approx(std::acos(-1) / 18));
  CHECK(starts[2][0] == Approx(std::acos(-1) / 9));
}

TEST_CASE("a mapping and a list draw the same positions") {
  const Assembling mapping(
      kChain + "pose: {seg_0_hinge: -1 .. 1, seg_2_hinge: {normal: [0, 0.1]}}\n", 7, 3);
  const Assembling list(kChain +
                            "pose:\n"
                            "- {joint: seg_2_hinge, value: {normal: [0, 0.1]}}\n"
                            "- {joint: \"seg_${i}_hinge\", for: {i: 1}, value: -1 .. 1}\n",
                        7, 3);
  CHECK(StartsOf(mapping) == StartsOf(list));
  CHECK(StartsOf(mapping)[0].size() == 1);
}

TEST_CASE("a joint has its start itself, but not in pose, too") {
  const std::string text =
      "parts: [{name: p, type: sphere, size: 1}]\n"
      "bodies: [{name: arm, joints: [{name: hinge, start: 30deg}], parts: [{name: q, type: sphere, "
      "size: 1}]}]\n";
  CHECK(Assembling(text).object().bodies[1].joints[0].start[0] == Approx(std::acos(-1) / 6));
  CHECK(OnlyFinding(text + "pose: {hinge: 1}\n") ==
        "5:8 the start of joint 'hinge' is given twice");
}

TEST_CASE("a ball joint starts turned, also at random") {
  const Assembling thing(
      "joints: [{name: socket, type: ball, start: random}]\n"
      "parts: [{name: p, type: sphere, size: 1}]\n");
  CHECK(thing.body().joints[0].start.size() == 4);
}

TEST_CASE("a start outside of the joint's range is an error of its key") {
  CHECK(OnlyFinding("joints: [{name: turn, range: [0, 1], start: 2}]\n"
                    "parts: [{name: p, type: sphere, size: 1}]\n") ==
        "3:38 start of joint 'turn' is 2, outside its range 0 .. 1");
}

TEST_CASE("a start in a unit that its joint does not have is an error") {
  const std::string text =
      "joints: [{name: slip, type: slide}, {name: turn}]\n"
      "parts: [{name: p, type: sphere, size: 1}]\n"
      "params: {far: 1m, angle: {choice: [1deg, 2deg]}}\n";
  CHECK(OnlyFinding(text + "pose: {turn: far / 2}\n") ==
        "6:8 pose of joint 'turn' is in rad, but this is in m");
  CHECK(OnlyFinding(text + "pose: {turn: {choice: [0, 1m]}}\n") ==
        "6:8 pose of joint 'turn' is in rad, but this is in m");
  CHECK(OnlyFinding(text + "pose: [{joint: slip, value: angle}]\n") ==
        "6:8 pose of joint 'slip' is in m, but this is in rad");
  CHECK(OnlyFinding("parts: [{name: p, type: sphere, size: 1}]\n"
                    "bodies: [{name: arm, joints: [{name: turn}], parts: [{name: q, type: sphere, "
                    "size: 1}]}]\n"
                    "expect: [{gap: [p, q], min: -9, at: {turn: 5mm}}]\n") ==
        "5:38 position of joint 'turn' is in rad, but this is in m");
}

TEST_CASE("a free body starts at its pose with its velocity, in the frame of its parent") {
  const TemporaryFolder folder;
  folder.Write("set.yaml",
               "mjforge: 1\nname: set\njoints: none\n"
               "parts: [{name: board, type: box, size: [1, 1, 1]}]\n"
               "bodies: [{name: peg, joints: free, parts: [{name: p, type: sphere, size: 1}]}]\n"
               "pose: [{joint: peg_joint0, pos: [2, 0, 0], velocity: [1, 0, 0, 5, 6, 7]}]\n");
  const Assembling thing(
      "joints: none\nparts: [{name: p, type: sphere, size: 1}]\n"
      "bodies: [{name: a, spec: set.yaml, pos: [0, 0, 5], euler: [0, 0, 90deg]}]\n",
      1, 0, folder.path());
  const model::Body& peg = thing.object().bodies[2];
  CHECK(peg.parent == -1);
  CHECK((peg.X_PB.p - Eigen::Vector3d(0, 2, 5)).norm() < 1e-12);
  REQUIRE(peg.joints[0].start_velocity.size() == 6);
  CHECK(std::abs(peg.joints[0].start_velocity[0]) < 1e-12);
  CHECK(peg.joints[0].start_velocity[1] == Approx(1));
  CHECK(peg.joints[0].start_velocity[3] == 5);
}

TEST_CASE("the start pose of a free root moves its bounds") {
  const Assembling thing(
      "parts: [{name: p, type: box, size: [1, 2, 3]}]\n"
      "pose: [{joint: joint0, pos: [0, 0, 4], euler: [90deg, 0, 0]}]\n");
  CHECK((thing.object().bounds.aabb.max - Eigen::Vector3d(1, 3, 6)).norm() < 1e-12);
}

TEST_CASE("starts that a joint cannot have are errors") {
  const std::string text =
      "joints: [{name: turn}]\n"
      "parts: [{name: p, type: sphere, size: 1}]\n";
  CHECK(OnlyFinding(text + "pose: [{joint: turn, velocity: [1, 2]}]\n") ==
        "5:8 pose of joint 'turn' has 2 instead of 1 numbers of velocity");
  CHECK(OnlyFinding(text + "pose: [{joint: turn, pos: [1, 2, 3]}]\n") ==
        "5:8 pose of joint 'turn' has a pose, but it is a hinge (write its `value`)");
  CHECK(
      OnlyFinding("parts: [{name: p, type: sphere, size: 1}]\npose: {joint0: 1}\n") ==
      "4:8 pose of joint 'joint0' cannot be set: it is free (in a list: `{joint: NAME, pos: [0, 0, "
      "1m]}`)");
  CHECK(OnlyFinding(text + "pose: [{actuator: motor, ctrl: 1}]\n") ==
        "5:8 pose: the object has no actuator 'motor'");
}

// Returns the text of an object with a hinge, a slide and the actuators.
std::string Driven(const std::string& actuators, const std::string& more = "") {
  return "joints: none\nparts: [{name: p, type: sphere, size: 1}]\n"
         "bodies: [{name: arm, joints: [{name: hinge, ref: 0.25, start: 0.5}, {name: slip, type: "
         "slide}], parts: [{name: q, type: sphere, size: 1}]}]\n"
         "mjcf: {actuator: [" +
         actuators + "]}\n" + more;
}

TEST_CASE("a position servo holds the start position of its joint") {
  const Assembling thing(Driven(
      "{position: {name: servo, joint: hinge, kp: 3, gear: 2}},"
      "{motor: {name: motor, joint: hinge}},"
      "{position: {name: idle, joint: slip}},"
      "{general: {name: affine, joint: hinge, gaintype: fixed, biastype: affine, gainprm: 4, "
      "biasprm: [1, -4, -1]}},"
      "{general: {name: filtered, joint: hinge, dyntype: filter, dynprm: 0.1, biastype: "
      "affine, gainprm: 2, biasprm: [0, -2]}},"
      "{intvelocity: {name: integrated, joint: hinge, kp: 5, actrange: [-1, 1]}}"));
  const std::vector<model::Setpoint>& setpoints = thing.object().setpoints;
  REQUIRE(setpoints.size() == 6);
  CHECK(setpoints[0].ctrl == 1.0);
  CHECK(!setpoints[0].act);
  CHECK(!setpoints[1].ctrl);
  CHECK(!setpoints[2].ctrl);
  CHECK(setpoints[3].ctrl == 0.25);
  CHECK(setpoints[4].ctrl == 0.5);
  CHECK(setpoints[4].act == 0.5);
  CHECK(!setpoints[5].ctrl);
  CHECK(setpoints[5].act == 0.5);
}

TEST_CASE("the spec's own setpoint wins") {
  const Assembling thing(
      Driven("{position: {name: servo, joint: hinge}}", "pose: [{actuator: servo, ctrl: 2}]\n"));
  CHECK(thing.object().setpoints[0].ctrl == 2.0);
  CHECK(Assembling(Driven("{position: {name: servo, joint: hinge}}",
                          "pose: [{actuator: servo, ctrl: 0}]\n"))
            .object()
            .setpoints.empty());
}

TEST_CASE("a setpoint that the actuator cannot have is an error") {
  CHECK(
      OnlyFinding(Driven("{position: {name: servo, joint: hinge, ctrlrange: [-0.1, 0.1]}}")) ==
      "6:20 ctrl of actuator 'thing_servo' is 0.5 at the start, outside its ctrlrange -0.1 .. 0.1 "
      "(the servo cannot hold its joint at the start; give it another `ctrl` in a list under "
      "`pose:`)");
  CHECK(OnlyFinding(Driven("{motor: {name: motor, joint: hinge}}",
                           "pose: [{actuator: motor, act: 1}]\n")) ==
        "7:8 actuator 'thing_motor' has no activation for `act` (set its `ctrl`)");
}

TEST_CASE("a start that violates an equality of joints is an error") {
  const auto coupled = [](const std::string& start) {
    return "joints: none\nparts: [{name: p, type: sphere, size: 1}]\n"
           "bodies:\n"
           "- {name: a, joints: [{name: ja, type: slide, ref: 1, start: 1.5}], parts: [{name: q, "
           "type: sphere, size: 1}]}\n"
           "- {name: b, joints: [{name: jb, start: " +
           start +
           "}], parts: [{name: r, type: sphere, size: 1}]}\n"
           "mjcf: {equality: [{joint: {name: gear, joint1: jb, joint2: ja, polycoef: [0, 2, 0, 0, "
           "0]}}]}\n";
  };
  CHECK(Assembling(coupled("1")).findings().empty());
  CHECK(OnlyFinding(coupled("0.5")) ==
        "8:20 the start violates equality 'thing_gear' by 0.5 rad (joint 'thing_jb' belongs at 1 "
        "rad)");
}

TEST_CASE("a start that violates a connect or a weld is an error") {
  const auto linked = [](const std::string& equality, const std::string& start) {
    return "joints: none\nparts: [{name: p, type: sphere, size: 1}]\n"
           "bodies:\n"
           "- {name: a, joints: [{name: ja}], parts: [{name: q, type: sphere, size: 1}]}\n"
           "- {name: b, joints: [{name: jb}], parts: [{name: r, type: sphere, size: 1}]}\n"
           "mjcf: {equality: [" +
           equality + "]}\npose: " + start + "\n";
  };
  const std::string connect = "{connect: {name: pin, body1: a, body2: b, anchor: [2, 0, 0]}}";
  const std::string weld = "{weld: {name: glue, body1: a, body2: b}}";
  CHECK(Assembling(linked(connect, "{ja: 0.5, jb: 0.5}")).findings().empty());
  CHECK(OnlyFinding(linked(connect, "{ja: 180deg}")) ==
        "8:20 the start violates equality 'thing_pin' by 4000 mm (give the joints of both bodies "
        "their starts)");
  CHECK(Assembling(linked(weld, "{ja: 0.5, jb: 0.5}")).findings().empty());
  // The position in `relpose` is that of the anchor.
  const std::string anchored =
      "{weld: {name: glue, body1: a, body2: b, anchor: [0, 2, 0], relpose: [0, 2, 0, 1, 0, 0, 0]}}";
  CHECK(Assembling(linked(anchored, "{ja: 0.5, jb: 0.5}")).findings().empty());
  CHECK(OnlyFinding(linked(weld, "{ja: 0.5}")) ==
        "8:20 the start violates equality 'thing_glue' by 0.5 rad (give the joints of both bodies "
        "their starts)");
}

}  // namespace
}  // namespace mjforge::assemble
