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

/// Returns the qpos0 of a joint, at which the joint's body has the pose X_PB: `ref` for a hinge or
/// slide, the identity for a ball joint; empty for a free joint.
sample::Numbers ZeroPosition(const Joint& joint);

/// Returns the number of values that a joint has in qvel.
std::size_t VelocityCount(const Joint& joint);

/// Returns the free joint of a body; null if the body has none.
const Joint* FreeJointOf(const Body& body);

/// Returns the motion of the body of a hinge, slide or ball joint when the joint moves from one
/// position to another: X_B0B1, the pose of the body after the motion in its frame before the
/// motion. Positions are as in qpos; an empty position stands for ZeroPosition().
Pose JointMotion(const Joint& joint, const sample::Numbers& from, const sample::Numbers& to);

/// Positions of some joints, by their full names, as in qpos.
using JointPositions = std::span<const std::pair<std::string, sample::Numbers>>;

/// Returns the poses X_FB of all bodies with an index from `first` on. Joints that `positions` does
/// not contain are at their start positions. Frame F is the body `first` or, if `first` is 0, the
/// object's frame W, in which X_PB of the root and of free bodies is given. Bodies that do not
/// descend from `first` get the identity; all bodies count as descendants of body 0. Equalities
/// between joints are ignored.
std::vector<Pose> SubtreePoses(const std::vector<Body>& bodies, std::size_t first,
                               JointPositions positions = {});

/// Returns a flag for each body with an index from `first` on, parallel to SubtreePoses(): true for
/// the body `first` and its descendants.
std::vector<bool> InSubtree(const std::vector<Body>& bodies, std::size_t first);

/// Returns the pose of a body in its parent with its joints at their start: X_PB after the motions
/// of the joints.
Pose StartPose(const Body& body);

/// Returns X_WB of every body of an object with all joints at zero.
std::vector<Pose> ZeroPoses(const std::vector<Body>& bodies);

}  // namespace mjforge::model
