// Forward kinematics of an object by MuJoCo's rules: poses of its bodies at given positions of its
// joints.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns a joint's numbers in qpos0, the position at which the joint does not move its body from
/// X_PB: `ref` for a hinge or slide, the identity quaternion for a ball joint. Returns an empty
/// list for a free joint.
sample::Numbers ZeroPosition(const Joint& joint);

/// Returns the number of a joint's values in qvel.
std::size_t VelocityCount(const Joint& joint);

inline bool HasStart(const Joint& joint) { return !joint.start.empty(); }
/// Returns true if any component of the joint's start velocity is not 0.
inline bool HasStartVelocity(const Joint& joint) {
  return std::ranges::any_of(joint.start_velocity, [](double number) { return number != 0; });
}

/// Returns true if `test` returns true for any joint of the object.
template <typename Test>
bool AnyJoint(const Object& object, const Test& test) {
  return std::ranges::any_of(
      object.bodies, [&](const Body& body) { return std::ranges::any_of(body.joints, test); });
}

/// Returns the joint with this name; null if there is none.
const Joint* FindJoint(const Object& object, std::string_view name);

/// Returns the free joint of a body; null if the body has none.
const Joint* FreeJointOf(const Body& body);

/// Returns X_B0B1, the pose of a body after the motion of its hinge, slide or ball joint, in the
/// frame of the body before the motion. Positions are as in qpos; an empty position is replaced by
/// ZeroPosition().
Pose JointMotion(const Joint& joint, const sample::Numbers& from, const sample::Numbers& to);

/// Full names of some joints, and their positions as in qpos.
using JointPositions = std::span<const std::pair<std::string, sample::Numbers>>;

/// Returns the poses X_FB of all bodies whose index is at least `first`. Joints that `positions`
/// does not contain are at their start positions. Frame F is that of the body `first`; if `first`
/// is 0, it is the object's frame W, in which X_PB of the root and of free bodies is given. The
/// pose is the identity for bodies that are not descendants of `first`; all bodies, including free
/// ones, are treated as descendants of body 0. Equalities between joints are ignored.
std::vector<Pose> SubtreePoses(const std::vector<Body>& bodies, std::size_t first,
                               JointPositions positions = {});

/// Returns a flag for each body whose index is at least `first`, parallel to SubtreePoses(): true
/// for the body `first` and its descendants; for all bodies if `first` is 0.
std::vector<bool> InSubtree(const std::vector<Body>& bodies, std::size_t first);

/// Returns the pose of a body in its parent with its joints at their start positions: X_PB,
/// followed by the motions of the joints.
Pose StartPose(const Body& body);

/// Returns the pose X_WB of every body of an object with all joints at zero.
std::vector<Pose> ZeroPoses(const std::vector<Body>& bodies);

}  // namespace mjforge::model
