// Drive tests: reach, overshoot, penetration and return of joints.
#include <numbers>

#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

std::string Child(const std::string& name, const std::string& pos, const std::string& joint,
                  const std::string& geom) {
  return "<body name=\"" + name + "\" pos=\"" + pos + "\"><joint name=\"" + name + "_joint\" " +
         joint + "/><geom name=\"" + name + "_geom\" " + geom + "/></body>";
}
const std::string kBar = R"(type="capsule" fromto="0 0 0 0.2 0 0" size="0.01")";
const std::string kDoorRange = R"(axis="0 0 1" limited="true" range="0 1.5")";

const Result::Joint& Only(const Examined& examined) {
  REQUIRE(examined.result);
  REQUIRE(examined.result->joints.size() == 1);
  return examined.result->joints.front();
}

TEST_CASE("a hinge reaches both ends, is stopped by its limits, and comes back") {
  const Examined door = Examine(Free(0, kCube + Child("door", "0.06 0 0", kDoorRange, kBar)));
  const Result::Joint& joint = Only(door);
  CHECK(joint.name == "door_joint");
  CHECK(joint.reach > 0.99);
  CHECK(joint.overshoot < 0.03 * 1.5);
  CHECK(joint.return_error < 0.01);
  CHECK(joint.penetration == 0);
  CHECK(door.Codes().empty());
}

TEST_CASE("springs, damping, dry friction, weight and actuators do not hold a joint back") {
  const std::string stiff = kDoorRange + R"( stiffness="30" damping="5" frictionloss="3")";
  const Examined door = Examine(Free(0, kCube + Child("door", "0.06 0 0", stiff, kBar)),
                                "<actuator><position joint=\"door_joint\" kp=\"100\"/></actuator>");
  CHECK(Only(door).reach > 0.99);
}

TEST_CASE("damping does not hold a joint of little inertia back") {
  const std::string damped = kDoorRange + R"( damping="0.5")";
  const std::string pin = R"(type="capsule" fromto="0 0 0 0.01 0 0" size="0.002")";
  const Examined door = Examine(Free(0, kCube + Child("door", "0.06 0 0", damped, pin)));
  CHECK(Only(door).reach > 0.99);
}

TEST_CASE("joints far from each other are driven as if each were alone") {
  const std::string range = R"(type="slide" axis="0 0 1" limited="true" range="-0.01 0.02")";
  const std::string box = R"(type="box" size="0.01 0.01 0.01")";
  std::string keys;
  std::vector<Result::Joint> alone;
  for (int i = 0; i < 5; ++i) {
    const std::string key =
        Child("key_" + std::to_string(i), std::to_string(0.1 * i) + " 0 0.1", range, box);
    keys += key;
    alone.push_back(Only(Examine("<body name=\"base\">" + kCube + key + "</body>")));
  }
  const Examined all = Examine("<body name=\"base\">" + kCube + keys + "</body>");
  REQUIRE(all.result);
  REQUIRE(all.result->joints.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(all.result->joints[i].name == alone[i].name);
    CHECK(all.result->joints[i].reach == Approx(alone[i].reach).margin(1e-3));
    CHECK(all.result->joints[i].overshoot == Approx(alone[i].overshoot).margin(1e-4));
    CHECK(all.result->joints[i].penetration == 0);
  }
}

TEST_CASE("a drawer behind a door is blocked by it, and is not if the door is open") {
  const std::string door =
      Child("door", "-0.2 -0.12 0", R"(axis="0 0 -1" limited="true" range="0 2")",
            R"(type="box" size="0.2 0.005 0.1" pos="0.2 0 0")");
  const std::string drawer =
      Child("drawer", "0 0 0", R"(type="slide" axis="0 -1 0" limited="true" range="0 0.15")",
            R"(type="box" size="0.15 0.1 0.08")");
  const std::string back = R"(<geom type="box" size="0.2 0.01 0.1" pos="0 0.13 0"/>
    <geom type="box" size="0.2 0.11 0.005" pos="0 0.01 -0.09"/>)";
  const std::string world = "<body name=\"case\">" + back + door + drawer + "</body>";
  CHECK(Examine(world).Codes() != Strings());
  model::Checks checks;
  checks.joints = {{.joints = {"drawer_joint"}, .positions = {{"door_joint", {1.9}}}},
                   {.joints = {"door_joint"}}};
  const Examined open = Examine(world, {}, checks);
  CHECK(open.Codes() == Strings());
  REQUIRE(open.result->joints.size() == 2);
  checks.drive = false;
  CHECK(Examine(world, {}, checks).result->joints.empty());
  checks.drive = true;
  checks.joints[0].skip = "it is locked";
  CHECK(Examine(world, {}, checks).result->joints.size() == 1);
}

TEST_CASE("what is asked of a joint that it cannot do is an error") {
  const std::string door = Child("door", "0.06 0 0", kDoorRange, kBar);
  const std::string ball =
      "<body name=\"swivel\" pos=\"0 0 0.06\"><joint name=\"swivel_joint\" "
      "type=\"ball\"/><geom size=\"0.005\"/></body>";
  const std::string world = Free(0, kCube + door + ball);
  const auto message = [&](const model::JointCheck& check) {
    model::Checks checks;
    checks.joints = {check};
    const Examined examined = Examine(world, {}, checks);
    return examined.findings.empty() ? std::string() : examined.findings[0].message;
  };
  CHECK(
      message({.joints = {"swivel_joint"}, .positions = {{"door_joint", {9}}}})
          .starts_with("checks.joints: joint 'door_joint' cannot stand at 516 deg: its range is "));
  CHECK(message({.joints = {"door_joint"}, .positions = {{"swivel_joint", {1}}}}) ==
        "checks.joints: the position of joint 'swivel_joint' takes 4 numbers, not 1");
  CHECK(message({.joints = {"swivel_joint"}, .rests = Eigen::Vector2d(0, 1)}) ==
        "checks.joints: `rests` is for hinges and slides, which 'swivel_joint' is not");
}

TEST_CASE("a joint of its own has its own thresholds") {
  const std::string soft = kDoorRange + R"( solreflimit="0.1 1")";
  const std::string world = Free(0, kCube + Child("door", "0.06 0 0", soft, kBar));
  model::Checks checks;
  checks.joint_overshoot = 0.001;
  CHECK(Examine(world, {}, checks).Codes() == Strings{"error physics/joint-overshoots"});
  checks.joints = {{.joints = {"door_joint"}, .overshoot = 0.5}};
  CHECK(Examine(world, {}, checks).Codes().empty());
}

TEST_CASE("a joint that something stands in the way of reaches as far as that") {
  // A post at 90 degrees of a door that should open by 1.5 rad more than that.
  const std::string range = R"(axis="0 0 1" limited="true" range="0 3")";
  const std::string post =
      "<body name=\"post\"><geom name=\"post_geom\" type=\"box\" "
      "size=\"0.01 0.01 0.01\" pos=\"0.06 0.15 0\"/></body>";
  const Examined door = Examine("<body name=\"frame\">" + kCube + post +
                                Child("door", "0.06 0 0", range, kBar) + "</body>");
  const Result::Joint& joint = Only(door);
  // The bar's radius and the post's half width, seen from the hinge.
  const double expected = std::numbers::pi / 2 - std::asin(0.02 / 0.15);
  CHECK(joint.reach == Approx(expected / 3).margin(0.03));
  REQUIRE(door.findings.size() >= 1);
  const diag::Finding& finding = door.findings[door.findings.size() - 1];
  CHECK(diag::CodeName(finding.code) == "physics/joint-blocked");
  CHECK(finding.message.find("'post' and 'door' collide") != std::string::npos);
}

TEST_CASE("a free body in the way of a joint is named") {
  const std::string range = R"(axis="0 0 1" limited="true" range="0 3")";
  const Examined door =
      Examine("<body name=\"frame\">" + kCube + Child("door", "0.06 0 0", range, kBar) +
              "</body><body name=\"mug\" pos=\"0.06 0.15 0\"><freejoint/><geom type=\"box\" "
              "size=\"0.01 0.01 0.01\"/></body>");
  REQUIRE(door.findings.size() >= 1);
  const diag::Finding& finding = door.findings[door.findings.size() - 1];
  CHECK(diag::CodeName(finding.code) == "physics/joint-blocked");
  CHECK(finding.message.find("'door' and 'mug' collide") != std::string::npos);
}

TEST_CASE("a screw is driven through what it makes turn") {
  // One turn lifts by 5 mm, so that the lift feels the turning inertia 1.6 million times.
  const std::string lid =
      "<body name=\"lid\" pos=\"0 0 0.065\">"
      "<joint name=\"lift\" type=\"slide\" axis=\"0 0 1\" limited=\"true\" range=\"0 0.01\"/>"
      "<joint name=\"turn\" axis=\"0 0 1\" limited=\"true\" range=\"0 12.56637\"/>"
      "<geom type=\"cylinder\" size=\"0.04 0.01\"/></body>";
  const std::string thread =
      "<equality><joint joint1=\"lift\" joint2=\"turn\" polycoef=\"0 0.000795775 0 0 "
      "0\"/></equality>";
  const Examined jar = Examine("<body name=\"jar\">" + kCube + lid + "</body>", thread);
  REQUIRE(jar.result);
  REQUIRE(jar.result->joints.size() == 2);
  for (const Result::Joint& joint : jar.result->joints) CHECK(joint.reach > 0.95);
  // The softness of this equality is another test's subject.
  CHECK(jar.Codes() == Strings{"error physics/equality-slips"});
}

TEST_CASE("a ball joint turns about each of its axes up to its range") {
  const std::string joint = R"(type="ball" limited="true" range="0 0.8")";
  const Examined arm = Examine(Free(0, kCube + Child("arm", "0 0 0.3", joint, kBar)));
  CHECK(Only(arm).reach > 0.98);
  CHECK(Only(arm).overshoot < 0.1 * 1.6);  // at most the push
}

TEST_CASE("an unlimited hinge makes a full turn; an unlimited slide has no ends") {
  const Examined wheel =
      Examine(Free(0, kCube + Child("wheel", "0 0 0.3", "axis=\"0 1 0\"", kBar)));
  CHECK(Only(wheel).reach > 0.99);
  CHECK(Only(wheel).overshoot == 0);
  const Examined rail =
      Examine("<body name=\"base\">" + kCube +
              Child("cart", "0 0 0.3", "type=\"slide\" axis=\"1 0 0\"", kBar) + "</body>");
  REQUIRE(rail.result);
  CHECK(rail.result->joints.empty());
}

TEST_CASE("a joint of several turns does not hit its end like a flywheel") {
  const std::string turns = R"(axis="0 0 1" limited="true" range="0 30")";
  const std::string wheel = R"(type="cylinder" size="0.05 0.01")";
  const Examined screw = Examine(Free(0, kCube + Child("wheel", "0 0 0.1", turns, wheel)));
  CHECK(Only(screw).overshoot < 0.1);
  CHECK(Only(screw).return_error < 0.005);
}

TEST_CASE("a joint comes back although what is on it swings") {
  const std::string back = R"(<body name="back" pos="-0.12 0 0">
    <joint name="tilt" axis="0 -1 0" range="0 0.3" limited="true"/>
    <geom type="box" size="0.01 0.2 0.2" pos="-0.03 0 0.25"/></body>)";
  const Examined seat =
      Examine(Free(0, kCube + R"(<body name="seat" pos="0 0 0.1"><joint name="turn" axis="0 0 1"/>
    <geom type="box" size="0.1 0.02 0.02"/>)" +
                          back + "</body>"));
  REQUIRE(seat.result);
  REQUIRE(seat.result->joints.size() == 2);
  CHECK(seat.result->joints[0].name == "turn");
  CHECK(seat.result->joints[0].return_error < 0.005);
}

TEST_CASE("soft limits let a joint overshoot") {
  const std::string soft = kDoorRange + R"( solreflimit="1 1")";
  const Examined door = Examine(Free(0, kCube + Child("door", "0.06 0 0", soft, kBar)));
  CHECK(Only(door).overshoot > 0);
  model::Checks strict;
  strict.joint_overshoot = 0.001;
  CHECK(Examine(Free(0, kCube + Child("door", "0.06 0 0", soft, kBar)), {}, strict).Codes() ==
        Strings{"error physics/joint-overshoots"});
}

TEST_CASE("a joint whose zero is outside its range is told so") {
  const std::string range = R"(axis="0 0 1" limited="true" range="0.3 1.5")";
  const Examined door = Examine(Free(0, kCube + Child("door", "0.06 0 0", range, kBar)));
  std::string messages;
  for (const diag::Finding& finding : door.findings) messages += finding.message + '\n';
  CHECK(messages.find("joint 'door_joint' begins 17.2 deg outside its range of 68.8 deg") !=
        std::string::npos);
  CHECK(Only(door).overshoot < 0.05);
}

TEST_CASE("joints are driven from the start pose, and the others held in it") {
  const std::string drawer = Child(
      "drawer", "0.06 0 0", "type=\"slide\" axis=\"1 0 0\" limited=\"true\" range=\"0.05 0.2\"",
      "type=\"box\" size=\"0.02 0.02 0.02\"");
  const auto key = [](const std::string& slide) {
    return "<keyframe><key name=\"m_start\" qpos=\"0 0 0 1 0 0 0 " + slide + "\"/></keyframe>";
  };
  const Examined inside = Examine(Free(0, kCube + drawer), key("0.1"));
  CHECK(inside.Codes() == Strings{"warning physics/loose"});  // 90 mm in front of the cube
  CHECK(Only(inside).reach > 0.99);
  CHECK(Only(inside).return_error < 0.001);
  const Examined outside = Examine(Free(0, kCube + drawer), key("0.02"));
  CHECK(outside.Codes().back() == "error physics/joint-overshoots");

  const std::string bar = Child("bar", "0.2 0.15 0", "type=\"slide\" axis=\"0 0 1\"", kBar);
  const std::string door = Child("door", "0.06 0 0", kDoorRange, kBar);
  const auto reach = [&](const std::string& bar_at) {
    const Examined both = Examine(
        Free(0, kCube + door + bar),
        "<keyframe><key name=\"m_start\" qpos=\"0 0 0 1 0 0 0 0 " + bar_at + "\"/></keyframe>");
    REQUIRE(both.result);
    return both.result->joints.at(0).reach;
  };
  CHECK(reach("0") < 0.9);
  CHECK(reach("0.1") > 0.99);
}

TEST_CASE("what is no part of the object may touch it") {
  const std::string cup =
      "<body name=\"cup\" pos=\"0.06 0.15 0\"><freejoint/><geom size=\"0.02\"/></body>";
  const Examined door = Examine(Free(0, kCube + Child("door", "0.06 0 0", kDoorRange, kBar)) + cup);
  REQUIRE(door.result);
  CHECK(door.result->joints[0].penetration == 0);
}

TEST_CASE("what has no name is called by its number") {
  const Examined pair =
      Examine("<body><freejoint/><geom size=\"0.1\"/><geom size=\"0.1\" pos=\"1 0 0\"/></body>");
  REQUIRE(pair.findings.size() == 1);
  CHECK(pair.findings[0].message.starts_with("part 'geom 1' of body 'body 1' is loose"));
}

}  // namespace
}  // namespace mjforge::physics
