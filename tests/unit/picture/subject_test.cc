#include "models.h"

namespace mjforge::picture {
namespace {

std::string MessageOf(const diag::Findings& findings) {
  REQUIRE(findings.size() == 1);
  return findings[0].message + (findings[0].hint.empty() ? "" : " / " + findings[0].hint);
}

TEST_CASE("joints are listed with their ranges and values") {
  const auto joints = Load(kChest)->joints();
  REQUIRE(joints.size() == 2);
  CHECK(joints[0].type == Joint::Type::kFree);
  CHECK(joints[1].name == "chest_lid_hinge");
  CHECK(joints[1].limited);
  CHECK(joints[1].range[1] == Approx(1.7453292));
  CHECK(joints[1].value == 0);
}

TEST_CASE("the start pose is shown") {
  const auto posed = [](const char* name) {
    return Load(
        "<mujoco model=\"chest\"><worldbody><body><joint/><geom size=\"1\"/></body>"
        "</worldbody><keyframe><key name=\"" +
        std::string(name) + "\" qpos=\"0.5\"/></keyframe></mujoco>");
  };
  CHECK(posed("chest_start")->joints()[0].value == 0.5);
  CHECK(posed("home")->joints()[0].value == 0);
}

TEST_CASE("a subject is moved to zero, and back to its start") {
  const auto subject = Load(
      "<mujoco model=\"chest\"><worldbody><body><joint ref=\"0.2\"/><geom size=\"1\"/></body>"
      "</worldbody><keyframe><key name=\"chest_start\" qpos=\"0.5\"/></keyframe></mujoco>");
  subject->Reset(Pose::kZero);
  CHECK(subject->joints()[0].value == 0);
  subject->Reset(Pose::kStart);
  CHECK(subject->joints()[0].value == 0.5);
}

TEST_CASE("a joint's name may lack its prefix") {
  const auto subject = Load(kChest);
  diag::Findings findings;
  for (const char* name : {"chest_lid_hinge", "lid_hinge", "hinge"}) {
    INFO(name);
    CHECK(subject->FindJoint(name, findings) == 1);
  }
  CHECK(findings.empty());
}

TEST_CASE("a joint that is not there is a finding with what was meant") {
  const auto subject = Load(kChest);
  diag::Findings findings;
  CHECK_FALSE(subject->FindJoint("lid_hnge", findings).has_value());
  CHECK(MessageOf(findings) == "there is no joint 'lid_hnge' / did you mean 'lid_hinge'?");
}

TEST_CASE("a name that fits two joints is a finding") {
  const auto subject = Load(
      "<mujoco><worldbody><body><joint name='a_x'/><joint name='b_x' axis='1 0 0'/>"
      "<geom size='1'/></body></worldbody></mujoco>");
  diag::Findings findings;
  CHECK_FALSE(subject->FindJoint("x", findings).has_value());
  CHECK(MessageOf(findings) == "'x' could be joint 'a_x' or 'b_x' / give its full name");
}

TEST_CASE("an object without joints says so") {
  diag::Findings findings;
  CHECK_FALSE(LoadGeom("size='1'")->FindJoint("hinge", findings).has_value());
  CHECK(MessageOf(findings) == "there is no joint 'hinge' / the object has no hinge or slide");
}

TEST_CASE("a joint stays within its range") {
  const auto subject = Load(kChest);
  diag::Findings findings;
  CHECK(subject->SetJoint(1, 1.2, findings));
  CHECK(subject->joints()[1].value == 1.2);
  CHECK_FALSE(subject->SetJoint(1, -0.1, findings));
  CHECK(MessageOf(findings) ==
        "joint 'chest_lid_hinge' does not reach -0.1 rad: its range is 0 to 1.74533");
  CHECK(subject->joints()[1].value == 1.2);
}

TEST_CASE("a free joint does not stand at one number") {
  diag::Findings findings;
  CHECK_FALSE(Load(kChest)->SetJoint(0, 1, findings));
  CHECK(MessageOf(findings) == "joint 'chest_free' is free and cannot be set by one number");
}

TEST_CASE("a sweep goes to both ends of the range and back") {
  diag::Findings findings;
  const std::vector<JointPositions> poses = Load(kChest)->Sweep(std::nullopt, findings);
  REQUIRE(poses.size() > 10);
  double least = 1;
  double most = 0;
  for (const JointPositions& pose : poses) {
    REQUIRE(pose.size() == 1);
    CHECK(pose[0].first == 1);
    least = std::min(least, pose[0].second);
    most = std::max(most, pose[0].second);
  }
  CHECK(least == 0);
  CHECK(most == Approx(1.7453292));
  CHECK(poses.front() == poses.back());
}

TEST_CASE("what has no range cannot be swept") {
  const auto subject = Load(kChest);
  diag::Findings findings;
  CHECK(subject->Sweep(0, findings).empty());
  CHECK(MessageOf(findings) == "joint 'chest_free' has no range to move through");
  findings.clear();
  CHECK(LoadGeom("size='1'")->Sweep(std::nullopt, findings).empty());
  CHECK(MessageOf(findings) == "no joint has a range to move through");
}

TEST_CASE("what MuJoCo refuses is not loaded, and why") {
  std::string why_not;
  CHECK(Loader().LoadText("<mujoco><worldbody><geom/></worldbody></mujoco>", {}, why_not) ==
        nullptr);
  CHECK(why_not.find("must be positive") != std::string::npos);
}

}  // namespace
}  // namespace mjforge::picture
