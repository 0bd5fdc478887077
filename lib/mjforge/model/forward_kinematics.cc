// Forward kinematics: search for joints, the motion of a single joint, and the poses of all bodies
// of a tree.
#include "mjforge/model/forward_kinematics.h"

#include <algorithm>

namespace mjforge::model {
namespace {

Eigen::Quaterniond QuaternionOf(const sample::Numbers& wxyz) {
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

}  // namespace

sample::Numbers ZeroPosition(const Joint& joint) {
  if (joint.type == "free") return {};
  if (joint.type == "ball") return {1, 0, 0, 0};
  return {NumberOf(joint, "ref", 0, 0)};
}

std::size_t VelocityCount(const Joint& joint) {
  if (joint.type == "free") return 6;
  return joint.type == "ball" ? 3 : 1;
}

const Joint* FindJoint(const Object& object, std::string_view name) {
  for (const Body& body : object.bodies) {
    if (const Joint* found = diag::Find(body.joints, name, &Joint::name)) return found;
  }
  return nullptr;
}

const Joint* FreeJointOf(const Body& body) { return diag::Find(body.joints, "free", &Joint::type); }

// Source of the order of rotation and translation: mj_kinematics of MuJoCo 2.2
// (src/engine/engine_core_smooth.c).
Pose JointMotion(const Joint& joint, const sample::Numbers& from, const sample::Numbers& to) {
  if (from.empty()) return to.empty() ? Pose() : JointMotion(joint, ZeroPosition(joint), to);
  if (to.empty()) return JointMotion(joint, from, ZeroPosition(joint));
  const Eigen::Vector3d axis = joint.axis.stableNormalized();
  if (joint.type == "slide") return {axis * (to[0] - from[0]), Eigen::Quaterniond::Identity()};
  const Eigen::Quaterniond q =
      joint.type == "ball" ? (QuaternionOf(from).conjugate() * QuaternionOf(to)).normalized()
                           : FromAxisAngle(axis, to[0] - from[0]);
  return {joint.pos - q * joint.pos, q};
}

namespace {

// Returns the pose of a body in its parent. Joints that `positions` does not contain are at their
// start positions.
Pose PoseInParent(const Body& body, JointPositions positions) {
  Pose X_PB = body.X_PB;
  for (const Joint& joint : body.joints) {
    const auto given = std::ranges::find(positions, joint.name, &JointPositions::value_type::first);
    const sample::Numbers& to = given == positions.end() ? joint.start : given->second;
    if (!to.empty()) X_PB = X_PB * JointMotion(joint, {}, to);
  }
  return X_PB;
}

}  // namespace

Pose StartPose(const Body& body) { return PoseInParent(body, {}); }

std::vector<bool> InSubtree(const std::vector<Body>& bodies, std::size_t first) {
  std::vector<bool> is_below(bodies.size() - first, first == 0);
  if (first == 0) return is_below;
  is_below.front() = true;
  for (std::size_t i = first + 1; i < bodies.size(); ++i) {
    const auto parent = static_cast<std::size_t>(std::max(bodies[i].parent, 0));
    is_below[i - first] = parent >= first && is_below[parent - first];
  }
  return is_below;
}

std::vector<Pose> SubtreePoses(const std::vector<Body>& bodies, std::size_t first,
                               JointPositions positions) {
  std::vector<Pose> X_FB(bodies.size() - first);
  const std::vector<bool> is_below = InSubtree(bodies, first);
  for (std::size_t i = first; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    if ((i == first && first > 0) || !is_below[i - first]) continue;
    const Pose X_PB = PoseInParent(body, positions);
    X_FB[i - first] =
        body.parent < 0 ? X_PB : X_FB[static_cast<std::size_t>(body.parent) - first] * X_PB;
  }
  return X_FB;
}

std::vector<Pose> ZeroPoses(const std::vector<Body>& bodies) {
  std::vector<Pose> X_WB;
  X_WB.reserve(bodies.size());
  for (const Body& body : bodies)
    X_WB.push_back(body.parent < 0 ? body.X_PB
                                   : X_WB[static_cast<std::size_t>(body.parent)] * body.X_PB);
  return X_WB;
}

std::vector<Pose> BodyPoses(const Object& object) { return SubtreePoses(object.bodies, 0); }

}  // namespace mjforge::model
