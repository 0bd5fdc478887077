// Forward kinematics of an object, by the rules of MuJoCo.
#include "mjforge/static_checks/forward_kinematics.h"

#include <algorithm>

namespace mjforge::static_checks {
namespace {

using model::Joint;
using model::Pose;

// Returns the position of a hinge or slide at which its body has the pose of the spec.
double ReferenceOf(const Joint& joint) {
  const auto ref = std::ranges::find(joint.attributes, "ref", &model::Attribute::name);
  return ref == joint.attributes.end() ? 0 : ref->numbers.front();
}

// Applies one joint as mj_kinematics of MuJoCo 2.2 does (src/engine/engine_core_smooth.c).
Pose Moved(const Pose& X_PB, const Joint& joint, const sample::Numbers& position) {
  if (position.empty() || joint.type == "free") return X_PB;
  const Eigen::Vector3d axis = joint.axis.stableNormalized();
  if (joint.type == "slide") {
    const double way = position[0] - ReferenceOf(joint);
    return {Eigen::Vector3d(X_PB * Eigen::Vector3d(axis * way)), X_PB.q};
  }
  const Eigen::Quaterniond turn =
      joint.type == "ball" ? Eigen::Quaterniond(position[0], position[1], position[2], position[3])
                           : model::FromAxisAngle(axis, position[0] - ReferenceOf(joint));
  const Eigen::Vector3d anchor = X_PB * joint.pos;
  const Eigen::Quaterniond q = (X_PB.q * turn).normalized();
  return {Eigen::Vector3d(anchor - q * joint.pos), q};
}

}  // namespace

std::vector<Pose> PosesAt(const model::Object& object,
                          std::span<const std::pair<std::string, sample::Numbers>> positions) {
  std::vector<Pose> poses;
  for (const model::Body& body : object.bodies) {
    // W is the frame of the root; the poses of free bodies are in W, too.
    Pose X = poses.empty() ? Pose() : body.X_PB;
    for (const Joint& joint : body.joints) {
      const auto given =
          std::ranges::find(positions, joint.name, [](const auto& one) { return one.first; });
      X = Moved(X, joint, given == positions.end() ? joint.start : given->second);
    }
    poses.push_back(body.parent < 0 ? X : poses[static_cast<std::size_t>(body.parent)] * X);
  }
  return poses;
}

}  // namespace mjforge::static_checks
