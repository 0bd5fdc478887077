// Tests of forward kinematics: motions of joints, and poses of bodies at the start state.

#include <catch2/catch.hpp>
#include <cmath>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

constexpr double kPi = 3.14159265358979323846;

bool IsNear(const model::Pose& X, const Eigen::Vector3d& p, const Eigen::Quaterniond& q) {
  return (X.p - p).norm() < 1e-12 && X.q.angularDistance(q) < 1e-7;
}

model::Joint MakeJoint(std::string_view type) {
  model::Joint joint;
  joint.type = type;
  joint.pos = {1, 0, 0};
  joint.axis = {0, 0, 2};
  joint.attributes.push_back({.name = "ref", .numbers = {0.5}, .text = {}});
  return joint;
}

TEST_CASE("a hinge turns about its anchor, from its ref if no position is given") {
  const model::Joint hinge = MakeJoint("hinge");
  const Eigen::Quaterniond quarter = model::FromAxisAngle({0, 0, 1}, kPi / 2);
  CHECK(IsNear(model::JointMotion(hinge, {}, {0.5 + kPi / 2}), {1, -1, 0}, quarter));
  CHECK(IsNear(model::JointMotion(hinge, {1}, {1 + kPi / 2}), {1, -1, 0}, quarter));
  CHECK(IsNear(model::JointMotion(hinge, {0.5 - kPi / 2}, {}), {1, -1, 0}, quarter));
  CHECK(IsNear(model::JointMotion(hinge, {}, {}), {0, 0, 0}, Eigen::Quaterniond::Identity()));
}

TEST_CASE("a slide moves along its axis of any length") {
  CHECK(IsNear(model::JointMotion(MakeJoint("slide"), {}, {2.5}), {0, 0, 2},
               Eigen::Quaterniond::Identity()));
}

TEST_CASE("a ball joint turns from one orientation to another about its anchor") {
  const model::Joint ball = MakeJoint("ball");
  const Eigen::Quaterniond a = model::FromAxisAngle({1, 2, 3}, 1);
  const Eigen::Quaterniond b = model::FromAxisAngle({3, 1, -2}, 2);
  const model::Pose D =
      model::JointMotion(ball, {a.w(), a.x(), a.y(), a.z()}, {b.w(), b.x(), b.y(), b.z()});
  CHECK(D.q.angularDistance(a.conjugate() * b) < 1e-7);
  CHECK((D * ball.pos - ball.pos).norm() < 1e-12);
}

TEST_CASE("bodies are at the start state, and so are bounds and mass") {
  const Assembling thing(
      "joints: none\n"
      "parts: [{name: base, type: sphere, size: 1, mass: 1}]\n"
      "bodies:\n"
      "- {name: arm, pos: [2, 0, 0], joints: [{name: hinge, axis: [0, 0, 1], ref: 90deg}],\n"
      "   parts: [{name: p, type: sphere, size: 1, pos: [3, 0, 0], mass: 1}]}\n"
      "- {name: tip, parent: arm, pos: [5, 0, 0], parts: [{name: q, type: sphere, size: 1, mass: "
      "2}]}\n"
      "pose: {hinge: 180deg}\n");
  CHECK(IsNear(model::BodyPoses(thing.object())[2], {2, 5, 0},
               model::FromAxisAngle({0, 0, 1}, kPi / 2)));
  const model::Bounds& bounds = thing.object().bounds;
  CHECK((bounds.aabb.max - Eigen::Vector3d(3, 6, 1)).norm() < 1e-12);
  CHECK((bounds.aabb.min - Eigen::Vector3d(-1, -1, -1)).norm() < 1e-12);
  CHECK(bounds.horizontal_radius == Approx(1 + std::sqrt(29)));
  CHECK((thing.object().mass_properties.p_FCm - Eigen::Vector3d(1.5, 3.25, 0)).norm() < 1e-12);
  CHECK(model::Contains(thing.object(), {2, 3, 0}));
  CHECK_FALSE(model::Contains(thing.object(), {5, 0, 0}));
}

TEST_CASE("the joints of the root move the whole object at the start") {
  const Assembling thing(
      "joints: [{name: lift, type: slide, axis: [0, 0, 1]}]\n"
      "parts: [{name: p, type: sphere, size: 1}]\n"
      "pose: {lift: 4}\n");
  CHECK(model::BodyPoses(thing.object())[0].p.z() == 4);
  CHECK(thing.object().bounds.bottom_offset == 3);
}

}  // namespace
}  // namespace mjforge::assemble
