// Tests of joints, their defaults and ranges.

#include <numbers>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

const std::string kBall = "parts: [{name: a, type: sphere, size: [1]}]\n";

TEST_CASE("an object is free to move unless it says otherwise") {
  const Assembling free(kBall);
  REQUIRE(free.body().joints.size() == 1);
  CHECK(free.body().joints[0].type == "free");
  CHECK(Assembling(kBall + "joints: none\n").body().joints.empty());
}

TEST_CASE("joints are hinges about z unless they say otherwise") {
  const Assembling thing(
      kBall +
      "joints:\n"
      "- {name: h, damping: 0.1}\n"
      "- {name: s, type: slide, axis: [0, 3, 4], pos: [1, 2, 3], range: [-1, 2]}\n"
      "- {name: u, range: [0, 1], limited: false}\n");
  const std::vector<model::Joint>& joints = thing.body().joints;
  REQUIRE(joints.size() == 3);
  CHECK(joints[0].name == "thing_h");
  CHECK(joints[0].type == "hinge");
  CHECK(joints[0].axis == Eigen::Vector3d::UnitZ());
  CHECK_FALSE(joints[0].range);
  CHECK(model::FindAttribute(joints[0].attributes, "damping")->numbers == sample::Numbers{0.1});
  CHECK(joints[1].axis.isApprox(Eigen::Vector3d(0, 0.6, 0.8)));
  CHECK(joints[1].range == Eigen::Vector2d(-1, 2));
  CHECK(joints[1].pos == Eigen::Vector3d(1, 2, 3));
  CHECK_FALSE(joints[2].range);
}

TEST_CASE("limits that MuJoCo would refuse are refused with their numbers") {
  const auto finding = [](const std::string& fields) {
    return OnlyFinding(kBall + "joints: [{name: j, " + fields + "}]\n");
  };
  CHECK(finding("range: [2, 1]") ==
        "4:27 range of joint 'j' is 2 .. 1; it must go from a smaller to a larger number");
  CHECK(finding("type: ball, range: [1, 2]") ==
        "4:39 range of joint 'j' is 1 .. 2; it must begin with 0 for a ball joint");
  CHECK(finding("type: free, range: [1, 2]") ==
        "4:39 range of joint 'j' is 1 .. 2; it has no meaning for a free joint");
  CHECK(finding("limited: true") == "4:29 limited of joint 'j' is true, but it has no range");
}

TEST_CASE("a free joint stands alone") {
  CHECK(OnlyFinding(kBall + "joints: [{name: h}, {name: f, type: free}]\n") ==
        "4:21 free joint 'thing_f' is not the only joint of its body (a free joint already allows "
        "every motion)");
}

// The equalities of an object: "NAME: JOINT1 = c0 + c1 JOINT2, solimp d0 dmin".
std::vector<std::string> EqualitiesOf(const Assembling& thing) {
  std::vector<std::string> texts;
  for (const model::Element& equality : model::ElementsOf(thing.object(), "equality")) {
    const auto text = [&](std::string_view name) {
      return model::FindAttribute(equality.attributes, name)->text;
    };
    const auto number = [&](std::string_view name, std::size_t i) {
      return expr::RoundedText(model::FindAttribute(equality.attributes, name)->numbers[i]);
    };
    texts.push_back(fmt::format("{}: {} = {} + {} {}, solimp {} {}", equality.name, text("joint1"),
                                number("polycoef", 0), number("polycoef", 1), text("joint2"),
                                number("solimp", 0), number("solimp", 1)));
  }
  return texts;
}

// Two bodies; the joint of the second one, the slide `move`, has these keys.
std::string Coupled(const std::string& couple) {
  return kBall +
         "bodies:\n"
         "- {name: b, parts: [{name: b, type: sphere, size: [1]}], joints: [{name: turn}]}\n"
         "- {name: c, parts: [{name: c, type: sphere, size: [1]}],\n"
         "   joints: [{name: move, type: slide, couple: {joint: turn, " +
         couple + "}}]}\n";
}

using Texts = std::vector<std::string>;

Texts CoupledAs(const std::string& couple) { return EqualitiesOf(Assembling(Coupled(couple))); }

TEST_CASE("a screw is a slide and a hinge that an equality couples") {
  const Assembling thing(kBall +
                         "joints: [{name: cap, pos: [1, 0, 0], damping: 0.1,\n"
                         "          screw: {axis: [1, 0, 0], lead: -3mm, turns: 2}}]\n");
  const std::vector<model::Joint>& joints = thing.body().joints;
  REQUIRE(joints.size() == 2);
  CHECK(joints[0].name == "thing_cap_rise");
  CHECK(joints[0].type == "slide");
  CHECK(joints[0].attributes.empty());
  CHECK(joints[0].range->isApprox(Eigen::Vector2d(-0.006, 0)));
  CHECK(joints[1].name == "thing_cap_turn");
  CHECK(joints[1].type == "hinge");
  CHECK(joints[1].range->isApprox(Eigen::Vector2d(0, 4 * std::numbers::pi)));
  CHECK(model::FindAttribute(joints[1].attributes, "damping")->numbers == sample::Numbers{0.1});
  for (const model::Joint& joint : joints) {
    CHECK(joint.axis == Eigen::Vector3d::UnitX());
    CHECK(joint.pos == Eigen::Vector3d(1, 0, 0));
  }
  CHECK(EqualitiesOf(thing) ==
        std::vector<std::string>{
            "thing_cap: thing_cap_turn = 0 + -2094 thing_cap_rise, solimp 0.99 0.999"});
}

TEST_CASE("a screw turns without an end, or between two numbers of turns") {
  const auto joints = [](const std::string& keys) {
    return Assembling(kBall + "joints: [{name: cap, screw: {lead: 2mm" + keys + "}}]\n")
        .body()
        .joints;
  };
  CHECK_FALSE(joints("")[0].range);
  CHECK_FALSE(joints("")[1].range);
  CHECK(joints(", turns: [-1, 0.5]")[0].range->isApprox(Eigen::Vector2d(-0.002, 0.001)));
}

TEST_CASE("a coupling has the joint with the larger numbers first") {
  CHECK(CoupledAs("ratio: 2") ==
        Texts{"thing_move: thing_move = 0 + 2 thing_turn, solimp 0.99 0.999"});
  CHECK(CoupledAs("ratio: -0.5") ==
        Texts{"thing_move: thing_turn = 0 + -2 thing_move, solimp 0.99 0.999"});
  CHECK(CoupledAs("polycoef: [3, 0.5]") ==
        Texts{"thing_move: thing_turn = -6 + 2 thing_move, solimp 0.99 0.999"});
  CHECK(CoupledAs("lead: 2 * pi * 1mm") ==
        Texts{"thing_move: thing_turn = 0 + 1000 thing_move, solimp 0.99 0.999"});
  CHECK(CoupledAs("ratio: 2, solimp: [0.5, 0.6, 1mm]") ==
        Texts{"thing_move: thing_move = 0 + 2 thing_turn, solimp 0.5 0.6"});
}

TEST_CASE("a curve and a joint that stays are not turned round") {
  CHECK(CoupledAs("polycoef: [0, 0.5, 0.1]") ==
        Texts{"thing_move: thing_move = 0 + 0.5 thing_turn, solimp 1 1"});
  CHECK(CoupledAs("polycoef: 1") ==
        Texts{"thing_move: thing_move = 1 + 0 thing_turn, solimp 0.99 0.999"});
}

TEST_CASE("threads and couplings without a sense are refused at their place") {
  const auto screw = [](const std::string& keys) {
    return OnlyFinding(kBall + "joints: [{name: cap, screw: {" + keys + "}}]\n");
  };
  CHECK(screw("lead: 0mm") == "4:36 lead of joint 'cap' is 0; it must be farther from 0");
  CHECK(screw("lead: 1mm, turns: 0") ==
        "4:48 turns of joint 'cap' is 0 .. 0; it must go from a smaller to a larger number");
  CHECK(OnlyFinding(Coupled("lead: 0mm")) ==
        "7:67 lead of joint 'move' is 0; it must be farther from 0");
  CHECK(OnlyFinding(
            Coupled("ratio: 1").replace(Coupled("").find("joint: turn"), 11, "joint: torn")) ==
        "7:55 couple of joint 'move' is 'torn', but the object has no joint of that name (did you "
        "mean 'turn'?)");
}

TEST_CASE("a joint follows another one that can lead it") {
  const auto finding = [](const std::string& leader, const std::string& couple) {
    return OnlyFinding(kBall +
                       "bodies:\n"
                       "- {name: b, parts: [{name: b, type: sphere, size: [1]}],\n"
                       "   joints: [{name: turn, type: " +
                       leader +
                       "}]}\n"
                       "- {name: c, parts: [{name: c, type: sphere, size: [1]}],\n"
                       "   joints: [{name: move, " +
                       couple + "}]}\n");
  };
  CHECK(finding("slide", "type: slide, couple: {joint: turn, lead: 1mm}") ==
        "8:55 joint 'turn' is a slide; a joint with a `lead` follows a hinge");
  CHECK(finding("ball", "type: slide, couple: {joint: turn, ratio: 2}") ==
        "8:55 joint 'turn' is a ball; a joint follows a hinge or a slide");
  CHECK(finding("hinge", "couple: {joint: move, ratio: 2}") ==
        "8:42 joint of joint 'move' is the joint itself");
  CHECK(finding("hinge", "type: \"${'hinge'}\", couple: {joint: turn, lead: 1mm}") ==
        "8:74 lead of joint 'move' has no meaning for a hinge (write a `ratio`)");
}

TEST_CASE("defaults of joints do not reach the axis and the range of a thread") {
  const Assembling thing(
      "defaults: {joint: {axis: [1, 0, 0], range: [0, 1], ref: 0.1, damping: 2}}\n" + kBall +
      "joints: [{name: cap, screw: {lead: 2mm}}]\n");
  const model::Joint& turn = thing.body().joints[1];
  CHECK(turn.axis == Eigen::Vector3d::UnitZ());
  CHECK_FALSE(turn.range);
  CHECK(model::FindAttribute(turn.attributes, "ref") == nullptr);
  CHECK(model::FindAttribute(turn.attributes, "damping") != nullptr);
}

}  // namespace
}  // namespace mjforge::assemble
