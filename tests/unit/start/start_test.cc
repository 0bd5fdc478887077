#include "mjforge/start/start.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "started.h"

namespace mjforge::start {
namespace {

using Values = std::vector<double>;

const std::string kDoor =
    "joints: none\n"
    "parts: [{name: frame, type: box, size: [1, 1, 1]}]\n"
    "bodies:\n"
    "  - name: door\n"
    "    pos: [1, 0, 0]\n"
    "    joints: [{name: hinge, axis: [0, 0, 1], pos: [0, 2, 0], range: [0, 3], ref: 0.5}]\n"
    "    parts: [{name: leaf, type: box, size: [1, 1, 1], role: visual, mass: 1}]\n"
    "    sites: [{name: knob, pos: [0, 3, 0]}]\n";

void CheckVector(const Eigen::Vector3d& v, const Eigen::Vector3d& meant) {
  CAPTURE(v.transpose(), meant.transpose());
  CHECK((v - meant).norm() < 1e-12);
}

void CheckValues(const Values& values, const Values& meant) {
  REQUIRE(values.size() == meant.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    CHECK(values[i] == Approx(meant[i]).margin(1e-12));
}

TEST_CASE("a body gets its start pose, and its hinge the start as ref") {
  const model::Object object = Started(kDoor + "pose: {hinge: 0.5 + pi / 2}\n");
  const model::Body& door = object.bodies[1];
  CheckVector(door.X_PB.p, {3, 2, 0});
  CheckVector(door.X_PB.q * Eigen::Vector3d::UnitX(), {0, 1, 0});
  const model::Joint& hinge = door.joints[0];
  CheckVector(hinge.pos, {0, 2, 0});
  REQUIRE(hinge.range);
  CHECK((*hinge.range)[1] == 3);
  CHECK(model::FindAttribute(hinge.attributes, "ref")->numbers[0] ==
        Approx(0.5 + std::numbers::pi / 2));
}

TEST_CASE("an object without a start elsewhere than at zero does not change") {
  for (const char* pose : {"", "pose: {hinge: 0.5}\n"}) {
    const model::Object before = Assembled(kDoor + pose);
    const model::Object after = Started(kDoor + pose);
    CHECK(after.bodies[1].X_PB.p == before.bodies[1].X_PB.p);
    CHECK(after.bodies[1].joints[0].attributes == before.bodies[1].joints[0].attributes);
  }
}

TEST_CASE("axes and anchors of a body's joints follow the joints after them") {
  const model::Object object = Started(
      "joints: none\n"
      "parts: [{name: base, type: box, size: [1, 1, 1]}]\n"
      "bodies:\n"
      "  - name: arm\n"
      "    joints:\n"
      "      - {name: a, axis: [1, 0, 0], pos: [1, 0, 0]}\n"
      "      - {name: b, axis: [0, 0, 1]}\n"
      "      - {name: c, type: slide, axis: [1, 0, 0]}\n"
      "    parts: [{name: bar, type: box, size: [1, 1, 1], role: visual, mass: 1}]\n"
      "pose: {b: 90deg, c: 2}\n");
  const std::vector<model::Joint>& joints = object.bodies[1].joints;
  CheckVector(joints[0].axis, {0, -1, 0});
  CheckVector(joints[0].pos, {-2, -1, 0});
  CheckVector(joints[1].axis, {0, 0, 1});
  CheckVector(joints[1].pos, {-2, 0, 0});
  CheckVector(joints[2].axis, {1, 0, 0});
  CheckVector(object.bodies[1].X_PB.p, {0, 2, 0});
}

TEST_CASE("positions of a ball joint in checks and expectations are measured from the start") {
  const model::Object object = Started(
      "joints: none\n"
      "parts: [{name: base, type: box, size: [1, 1, 1]}]\n"
      "bodies:\n"
      "  - name: arm\n"
      "    pos: [5, 0, 0]\n"
      "    joints: [{name: b, type: ball}, {name: c, type: slide}]\n"
      "    parts: [{name: bar, type: box, size: [1, 1, 1], mass: 1}]\n"
      "pose: {b: [1, 0, 0, 1]}\n"
      "expect: [{apart: [bar, base], at: {b: [1, 0, 0, 1]}}]\n"
      "checks: {joints: [{joint: c, at: {b: [1, 0, 0, 0]}}]}\n");
  CHECK(object.bodies[1].joints[0].start.empty());
  const auto& position = object.expectations[0].positions[0].second;
  CheckValues({position.begin(), position.end()}, {1, 0, 0, 0});
  const double half = std::sqrt(0.5);
  CheckValues(object.checks.joints[0].positions[0].second, {half, 0, 0, -half});
}

TEST_CASE("polynomials of equalities are shifted by the start") {
  // d = 0.5 for `hinge`: y = 1 + 2 x + 3 x^2 of x = x' + 0.5 is 2.75 + 5 x' + 3 x'^2.
  const std::string second =
      "  - name: lid\n"
      "    joints: [{name: turn}]\n"
      "    parts: [{name: plate, type: box, size: [1, 1, 1], role: visual, mass: 1}]\n"
      "pose: {hinge: 1, turn: 0.25}\n"
      "mjcf:\n"
      "  tendon: [{fixed: {name: sum, children: [{joint: {joint: hinge, coef: 4}}]}}]\n"
      "  equality:\n";
  const model::Object object = Started(
      kDoor + second +
      "    - {joint: {active: false, name: curve, joint1: turn, joint2: hinge, polycoef: [1, 2, 3, "
      "0, 0]}}\n"
      "    - {joint: {active: false, name: alone, joint1: hinge, polycoef: [1, 2, 0, 0, 0]}}\n"
      "    - {tendon: {name: string, tendon1: sum}}\n");
  CheckValues(NumbersIn(object, "equality", "thing_curve", "polycoef"), {2.5, 5, 3, 0, 0});
  CheckValues(NumbersIn(object, "equality", "thing_alone", "polycoef"), {0.5, 2, 0, 0, 0});
  CheckValues(NumbersIn(object, "equality", "thing_string", "polycoef"), {-2, 1, 0, 0, 0});
}

TEST_CASE("welds and connections keep what they held at the old zero") {
  const model::Object object = Started(
      kDoor +
      "pose: {hinge: 0.5 + pi / 2}\n"
      "mjcf:\n"
      "  equality:\n"
      "    - {weld: {active: false, name: grown, body1: door, anchor: [0, 1, 0]}}\n"
      "    - {weld: {active: false, name: posed, body1: door, relpose: [1, 2, 3, 1, 0, 0, 0]}}\n"
      "    - {connect: {name: closed, body1: door, anchor: [0, 2, 0]}}\n"
      "    - {connect: {active: false, name: open, body1: door, anchor: [0, 1, 0]}}\n");
  CheckValues(NumbersIn(object, "equality", "thing_grown", "relpose"), {-1, 1, 0, 1, 0, 0, 0});
  CheckValues(NumbersIn(object, "equality", "thing_posed", "relpose"), {1, 2, 3, 1, 0, 0, 0});
  const auto equalities = model::ElementsOf(object, "equality");
  CHECK(equalities[2].tag == "connect");
  CHECK(equalities[3].tag == "weld");
  CheckValues(NumbersIn(object, "equality", "thing_open", "anchor"), {1, 1, 0});
  CheckValues(NumbersIn(object, "equality", "thing_open", "relpose"), {0, 1, 0, 1, 0, 0, 0});
  CheckValues(NumbersIn(object, "equality", "thing_open", "torquescale"), {0});
}

TEST_CASE("a tendon's spring gets a rest length if a ball joint is on its path") {
  const model::Object object = Started(
      "joints: none\n"
      "parts: [{name: base, type: box, size: [1, 1, 1]}]\n"
      "sites: [{name: hook, pos: [4, 0, 0]}]\n"
      "bodies:\n"
      "  - name: arm\n"
      "    joints: [{name: b, type: ball}]\n"
      "    parts: [{name: bar, type: box, size: [1, 1, 1], role: visual, mass: 1}]\n"
      "    sites: [{name: tip, pos: [1, 0, 0]}, {name: top, pos: [0, 0, 2]}]\n"
      "pose: {b: [1, 0, 0, 1]}\n"
      "mjcf:\n"
      "  tendon:\n"
      "    - {spatial: {name: rope, stiffness: 2, children: [{site: {site: hook}}, {site: {site: "
      "tip}}, {pulley: {divisor: 2}}, {site: {site: hook}}, {site: {site: tip}}]}}\n"
      "    - {spatial: {name: slack, children: [{site: {site: hook}}, {site: {site: tip}}]}}\n"
      "    - {spatial: {name: inner, stiffness: 2, children: [{site: {site: top}}, {site: {site: "
      "tip}}]}}\n");
  CheckValues(NumbersIn(object, "tendon", "thing_rope", "springlength"), {4.5});
  CheckValues(NumbersIn(object, "tendon", "thing_slack", "springlength"), {});
  CheckValues(NumbersIn(object, "tendon", "thing_inner", "springlength"), {});
}

}  // namespace
}  // namespace mjforge::start
