// Actuators that are too weak or set to impossible positions, and joints that nobody can move.
#include "examined.h"

namespace mjforge::physics {
namespace {

using Strings = std::vector<std::string>;

/// A hatch of 2 kg whose centre of mass is 0.25 m from its hinge: 4.9 Nm hold it level.
std::string Hatch(const std::string& joint = "damping=\"1\"") {
  return R"(<body name="frame"><geom type="box" size="0.03 0.3 0.03" pos="-0.05 0 0"/>
    <geom type="box" size="0.03 0.3 0.005" pos="-0.02 0 -0.035"/>
    <body name="hatch"><joint name="lift" axis="0 -1 0" limited="true" range="0 1.5" )" +
         joint + R"(/><geom type="box" size="0.23 0.28 0.01" pos="0.25 0 0" mass="2"/>
    </body></body>)";
}

Strings Codes(const std::string& joint, const std::string& actuator) {
  return Examine(Hatch(joint), actuator.empty() ? "" : "<actuator>" + actuator + "</actuator>")
      .Codes();
}

const Strings kNone;
const Strings kActuator = {"warning physics/actuator"};
const Strings kHeavy = {"warning physics/joint-heavy"};
const std::string kDamped = "damping=\"1\"";

}  // namespace

TEST_CASE("a servo must hold its joint everywhere in its range") {
  const auto servo = [](const std::string& kp, const std::string& more = {}) {
    return Codes(kDamped,
                 "<position name=\"servo\" joint=\"lift\" kp=\"" + kp + "\" " + more + "/>");
  };
  CHECK(servo("500") == kNone);
  CHECK(servo("500", R"(forcelimited="true" forcerange="-5 5")") == kNone);
  CHECK(servo("500", R"(forcelimited="true" forcerange="-4.8 4.8")") == kActuator);
  // It gives way by 0.98 rad, more than a fifth of the range.
  CHECK(servo("5") == kActuator);
}

TEST_CASE("a motor must lift the weight of its joint in the right direction") {
  const auto motor = [](const std::string& range, const std::string& gear) {
    return Codes(kDamped, "<motor name=\"motor\" joint=\"lift\" ctrllimited=\"true\" ctrlrange=\"" +
                              range + "\" gear=\"" + gear + "\"/>");
  };
  CHECK(motor("-1 1", "5") == kNone);
  CHECK(motor("-1 1", "-5") == kNone);
  CHECK(motor("0 1", "5") == kNone);
  CHECK(motor("0 1", "-5") == kActuator);
  CHECK(motor("-1 1", "4.8") == kActuator);
  CHECK(motor("-1 1", "0") == kActuator);
}

TEST_CASE("the message of a weak actuator has the force, the need and the place") {
  const Examined weak = Examine(Hatch(), R"(<actuator><motor name="motor" joint="lift" gear="2"
                          ctrllimited="true" ctrlrange="-1 1"/></actuator>)");
  REQUIRE(weak.Codes() == kActuator);
  CHECK(weak.findings.begin()->message ==
        "actuator 'motor' is too weak for joint 'lift': it has 2 Nm, and 4.91 Nm are needed at 0 "
        "deg");
}

TEST_CASE("dry friction and springs count for actuators") {
  const std::string motor = R"(<motor joint="lift" gear="6" ctrllimited="true" ctrlrange="-1 1"/>)";
  CHECK(Codes(kDamped, motor) == kNone);
  CHECK(Codes(kDamped + " frictionloss=\"2\"", motor) == kActuator);
  CHECK(Codes(kDamped + " stiffness=\"20\"", motor) == kActuator);
}

TEST_CASE("a servo is not set far beyond the range of its joint") {
  const auto servo = [](const std::string& range) {
    return Codes(kDamped, "<position joint=\"lift\" kp=\"500\" ctrllimited=\"true\" ctrlrange=\"" +
                              range + "\"/>");
  };
  CHECK(servo("0 1.5") == kNone);
  CHECK(servo("-0.7 2.2") == kNone);
  CHECK(servo("0 90") == kActuator);
  CHECK(servo("-90 0") == kActuator);
}

TEST_CASE("a joint is one that a person or its actuator can move") {
  // 400 N at 0.48 m and 0.01 m from the axis are 192 Nm; in 10 s it moves by 1.5 rad.
  CHECK(Codes("damping=\"1200\"", "") == kNone);
  CHECK(Codes("damping=\"1400\"", "") == kHeavy);
  CHECK(Codes("frictionloss=\"190\"", "") == kNone);
  CHECK(Codes("frictionloss=\"200\"", "") == kHeavy);
  CHECK(Codes("armature=\"4000\"", "") == kHeavy);
  CHECK(Codes("damping=\"1400\"", "<position joint=\"lift\" kp=\"5000\"/>") == kNone);
}

}  // namespace mjforge::physics
