// Forward kinematics of an object, by the rules of MuJoCo: poses of its bodies at given positions
// of its joints.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/model/object.h"

namespace mjforge::model {

/// Returns the value of a joint in qpos0, with which its body has the pose that the spec states:
/// `ref` of a hinge or slide, the identity of a ball joint; empty for a free joint.
sample::Numbers ZeroPosition(const Joint& joint);

/// Returns the count of numbers that a joint has in qvel.
std::size_t VelocityCount(const Joint& joint);

/// Returns the free joint of a body; null if the body has none.
const Joint* FreeJointOf(const Body& body);

/// Returns the motion of the body of a hinge, slide or ball joint when the joint moves from one
/// position to another: X_B0B1, the pose of the body after the motion in its frame before the
/// motion. Positions are as in qpos; an empty one is ZeroPosition().
Pose JointMotion(const Joint& joint, const sample::Numbers& from, const sample::Numbers& to);

/// Positions of some joints, by their full names, as in qpos.
using JointPositions = std::span<const std::pair<std::string, sample::Numbers>>;

/// Returns X_FB of the bodies from `first` on; other joints than `positions` are at their start
/// positions. F is the body `first`, but for the root the object's frame W, in which X_PB of the
/// root and of free bodies is given. Bodies that are not below `first` have the identity; the
/// world's children count as below the root. Equalities between joints are ignored.
std::vector<Pose> SubtreePoses(const std::vector<Body>& bodies, std::size_t first,
                               JointPositions positions = {});

/// Returns whether each body from `first` on is `first` or below it, parallel to SubtreePoses().
std::vector<bool> InSubtree(const std::vector<Body>& bodies, std::size_t first);

/// Returns the pose of a body in its parent with its joints at their start: X_PB after the motions
/// of the joints.
Pose StartPose(const Body& body);

/// Returns X_WB of every body of an object with all joints at zero.
std::vector<Pose> ZeroPoses(const std::vector<Body>& bodies);

}  // namespace mjforge::model
