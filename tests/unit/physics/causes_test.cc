// Messages that name the cause of what a simulation shows, and what helps.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

/// Returns "message (hint)" of the findings with a code.
Strings TextsOf(const Examined& examined, std::string_view code) {
  Strings texts;
  for (const diag::Finding& finding : examined.findings) {
    if (diag::CodeName(finding.code) == code)
      texts.push_back(finding.message + " (" + finding.hint + ")");
  }
  return texts;
}

std::string JointedBody(const std::string& name, const std::string& pos, const std::string& joint,
                        const std::string& geom) {
  return "<body name=\"" + name + "\" pos=\"" + pos + "\"><joint name=\"" + name + "_joint\" " +
         joint + "/><geom name=\"" + name + "_geom\" " + geom + "/></body>";
}

const std::string kBall = R"(type="sphere" size="0.02")";
const std::string kRod = R"(type="capsule" fromto="0 0 0 0.2 0 0" size="0.01")";

TEST_CASE("a simulation that diverges names the spring, the gain or the contact") {
  const auto texts = [](const std::string& joint, const std::string& sections = {},
                        const std::string& geom = kBall) {
    return TextsOf(Examine(Free(0, kCube + JointedBody("head", "0 0 0.2", joint, geom)), sections),
                   "physics/unstable");
  };
  const std::string slide = R"(type="slide" axis="0 0 1")";
  CHECK(texts(slide + R"( stiffness="1e8" springref="0.1")") ==
        Strings{"the simulation diverges as 'm' settles: the spring of joint 'head_joint' of body "
                "'head' is too stiff for a timestep of 2 ms (MuJoCo: Nan, Inf or huge value in "
                "QACC at DOF 2. The simulation is unstable.) (lower its `stiffness`, give the "
                "joint an `armature` or the body more mass, or use a timestep below 0.036 ms)"});
  CHECK(texts(R"(axis="1 0 0")",
              R"(<actuator><position name="servo" joint="head_joint" kp="1e9"/></actuator>)",
              R"(type="sphere" size="0.02" pos="0 0.1 0")") ==
        Strings{"the simulation diverges as 'm' settles: the gain of 1e+09 of actuator 'servo' at "
                "joint 'head_joint' is too stiff for a timestep of 2 ms (MuJoCo: Nan, Inf or huge "
                "value in QACC at DOF 1. The simulation is unstable.) (lower it, give the joint an "
                "`armature` or its body more mass, or use a timestep below 0.0011 ms)"});
  CHECK(
      texts(slide,
            R"(<actuator><velocity name="brake" joint="head_joint" kv="1e6"/></actuator>)") ==
      Strings{"the simulation diverges as 'm' settles: the gain of 1000000 of actuator 'brake' at "
              "joint 'head_joint' is too strong for a timestep of 2 ms (MuJoCo: Nan, Inf or huge "
              "value in QACC at DOF 6. The simulation is unstable.) (lower it, give the joint an "
              "`armature` or its body more mass, or use a timestep below 6.5e-05 ms)"});
  CHECK(texts(slide + R"( range="0 0.1" limited="true")",
              R"(<tendon><fixed name="rope" stiffness="1e8" springlength="0.2">)"
              R"(<joint joint="head_joint" coef="1"/></fixed></tendon>)") ==
        Strings{"the simulation diverges as 'm' settles: the spring of tendon 'rope' is too stiff "
                "for a timestep of 2 ms (MuJoCo: Nan, Inf or huge value in QACC at DOF 2. The "
                "simulation is unstable.) (lower its `stiffness`, give the joints an `armature`, "
                "or use a timestep below 0.036 ms)"});
  const std::string hard =
      R"(<geom name="post" type="box" size="0.05 0.05 0.05" pos="0.08 0 0" solref="-1e15 -1"/>)";
  // MuJoCo 2.2 states half of the depth for boxes of equal faces.
  const std::string depth = engine::kHasFixedBuffers ? "10" : "20";
  CHECK(TextsOf(Examine(Free(0, kCube) + "<body name=\"other\">" + hard + "</body>"),
                "physics/unstable") ==
        Strings{"the simulation diverges as 'm' settles: geoms 'cube' and 'post' start " + depth +
                " mm in each other (MuJoCo: Nan, Inf or huge value in QACC at DOF 0. "
                "The simulation is unstable.) (make room, or add `contact: exclude`)"});
  CHECK(TextsOf(Examine(Free(0, kCube), R"(<option gravity="0 0 -1e11"/>)"), "physics/unstable") ==
        Strings{"the simulation diverges as 'm' settles: joint 'free' of body 'root' is "
                "the first (MuJoCo: Nan, Inf or huge value in QACC at DOF 2. The "
                "simulation is unstable.) (use a smaller timestep, softer contacts, or "
                "larger masses and inertias for its forces)"});
}

TEST_CASE("energy may come from equalities, tendons and the start pose, where there are any") {
  const std::string world =
      Free(0, kCube + JointedBody("lift", "0 0 0.09",
                                  R"(type="slide" damping="5" limited="true" range="0 0.3")",
                                  R"(type="sphere" size="0.03")"));
  const std::string motor =
      R"(<actuator><general joint="lift_joint" biastype="affine" biasprm="40 0 0"/></actuator>)";
  CHECK(TextsOf(Examine(world, motor), "physics/gains-energy") ==
        Strings{"'m' gains energy as it settles: 1.33 of mass * gravity * size, more than 0.02 "
                "(look for parts that push each other apart, springs, or actuators)"});
  const std::string more = R"(<equality><joint joint1="lift_joint" active="false"/></equality>
    <tendon><fixed name="rope"><joint joint="lift_joint" coef="1"/></fixed></tendon>
    <keyframe><key name="m_start" qpos="0 0 0 1 0 0 0 0.01"/></keyframe>)";
  CHECK(TextsOf(Examine(world, motor + more), "physics/gains-energy") ==
        Strings{"'m' gains energy as it settles: 1.09 of mass * gravity * size, more than 0.02 "
                "(look for parts that push each other apart, springs, actuators, equalities that "
                "the start violates, tendons that are stretched, or a start pose outside of "
                "limits)"});
}

TEST_CASE("a blocked joint names the equality or the tendon that holds it back") {
  const auto texts = [](const std::string& sections) {
    const std::string world =
        "<body name=\"base\">" + kCube +
        JointedBody("a", "0 0 0.1", R"(axis="0 0 1" limited="true" range="0 1")", kRod) +
        JointedBody("b", "0 0 0.2", R"(axis="0 0 1" limited="true" range="0 0.2")", kRod) +
        "</body>";
    return TextsOf(Examine(world, sections), "physics/joint-blocked");
  };
  const std::string gear =
      R"(<equality><joint name="gear" joint1="a_joint" joint2="b_joint"/></equality>)";
  CHECK(texts(gear) == Strings{"joint 'a_joint' reaches only 22.7 % of its range of 57.3 deg (it "
                               "is held back by equality 'gear' with joint 'b_joint')"});
  CHECK(texts(R"(<tendon><fixed name="rope" limited="true" range="-1 0.3">)"
              R"(<joint joint="a_joint" coef="1"/></fixed></tendon>)"
              R"(<keyframe><key name="m_start" qpos="0.1 0"/></keyframe>)") ==
        Strings{"joint 'a_joint' reaches only 32.5 % of its range of 57.3 deg (it is "
                "held back by tendon 'rope'; it begins at the start pose, unless `at` "
                "in `checks: joints:` says another)"});
}

TEST_CASE("a collision with a link says that `at` can move it away") {
  const std::string world =
      "<body name=\"base\">" + kCube +
      JointedBody("door", "0.06 0 0", R"(axis="0 0 1" limited="true" range="0 3")", kRod) +
      JointedBody("latch", "0.06 0.15 0",
                  R"(type="slide" axis="0 0 1" limited="true" range="0 0.1")",
                  R"(type="box" size="0.01 0.01 0.01")") +
      "</body>";
  // The share depends on how far MuJoCo's release lets the door into the latch.
  const std::string share = engine::kHasFixedBuffers ? "50.2" : "53.2";
  CHECK(TextsOf(Examine(world), "physics/joint-blocked") ==
        Strings{"joint 'door_joint' reaches only " + share +
                " % of its range of 172 deg: 'door' and 'latch' collide (use a shorter range, make "
                "room, or add `contact: exclude`; `at` in `checks: joints:` says where other "
                "joints stand meanwhile)"});
}

TEST_CASE("an object that topples names the joint that moved") {
  model::Checks checks;
  checks.stable = true;
  const std::string arm =
      JointedBody("arm", "0 0 0.1", R"(axis="0 1 0" damping="0.1" limited="true" range="0 1.2")",
                  R"(type="capsule" fromto="0 0 0 0.02 0 0.3" size="0.02" mass="5")");
  CHECK(
      TextsOf(Examine(Free(0.05, kCube + arm), {}, checks), "physics/topples") ==
      Strings{
          "'m' topples: it leans over by 47.8 deg, more than 15 deg, as joint 'arm_joint' moves by "
          "61.4 deg (give it a wider foot or a lower centre of mass)"});
}

TEST_CASE("a joint that does not rest says that its friction is too weak") {
  const auto texts = [](const std::string& friction) {
    model::Checks checks;
    checks.joints = {{.joints = {"lid_joint"}, .rests = Eigen::Vector2d(0.9, 1.2)}};
    const std::string joint = R"(axis="0 -1 0" damping="0.05" limited="true" range="0 2" )";
    const std::string world = "<body name=\"base\">" + kCube +
                              JointedBody("lid", "0 0 0.1", joint + friction, kRod) + "</body>";
    return TextsOf(Examine(world, R"(<keyframe><key name="m_start" qpos="1"/></keyframe>)", checks),
                   "physics/joint-rests");
  };
  CHECK(texts(R"(frictionloss="0.01")") ==
        Strings{"joint 'lid_joint' rests at -0.0813 deg, 51.6 deg beyond where `rests` has it, "
                "51.6 deg to 68.8 deg (its dry friction of 0.01 Nm cannot hold the 0.0657 Nm that "
                "pull at it there)"});
}

TEST_CASE("a limit that gives way far asks for an armature, which helps") {
  const auto texts = [](const std::string& more) {
    const std::string joint =
        R"(axis="0 -1 0" damping="0.05" stiffness="20" springref="3" limited="true" range="0 1" )";
    const std::string world = "<body name=\"base\">" + kCube +
                              JointedBody("lid", "0 0 0.1", joint + more, kRod) + "</body>";
    return TextsOf(Examine(world), "physics/joint-rests");
  };
  CHECK(texts("") ==
        Strings{"joint 'lid_joint' rests at 91.9 deg, 34.6 deg beyond its range, 0 deg to 57.3 deg "
                "(a spring or weight presses it: use a harder limit (a smaller solreflimit), or a "
                "softer spring; the limit of a light part gives way far, so that the joint needs "
                "an `armature`, too)"});
  CHECK(texts(R"(armature="0.5")") == Strings{});
}

}  // namespace
}  // namespace mjforge::physics
