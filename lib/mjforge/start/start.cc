// MoveZeroToStart(): rewrites an object so that its start becomes MuJoCo's zero configuration
// (qpos0).
#include "mjforge/start/start.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "mjforge/start/configurations.h"
#include "mjforge/start/rewriting.h"

namespace mjforge::start {
namespace {

using model::Body;
using model::Joint;
using model::Pose;

// Conversion of a ball joint's quaternions when its zero moves: q becomes `before` * q * `after`.
struct BallChange {
  std::string joint;
  Eigen::Quaterniond before;
  Eigen::Quaterniond after;
};

// Returns the conversions of all ball joints that do not start at zero (the identity), or whose
// body is turned by the motion of its later joints from zero to the start.
std::vector<BallChange> BallChanges(const model::Object& object) {
  std::vector<BallChange> changes;
  for (const Body& body : object.bodies) {
    for (std::size_t i = 0; i < body.joints.size(); ++i) {
      const Joint& joint = body.joints[i];
      if (joint.type != "ball") continue;
      const Eigen::Quaterniond later = MotionOfLaterJoints(body, i).q;
      const Eigen::Quaterniond own = model::JointMotion(joint, {}, joint.start).q;
      if (IsTurned(later) || IsTurned(own))
        changes.push_back({joint.name, (own * later).conjugate(), later});
    }
  }
  return changes;
}

template <typename Numbers>
void Convert(const BallChange& change, Numbers& wxyz) {
  const Eigen::Quaterniond own(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  const Eigen::Quaterniond q = (change.before * own * change.after).normalized();
  wxyz = {q.w(), q.x(), q.y(), q.z()};
}

// Converts positions of ball joints in `expect:`, whose joint names have the object's prefix, and
// in `checks:`, whose joint names have no prefix.
void ConvertPositions(const std::vector<BallChange>& changes, model::Object& object) {
  const auto find = [&](const std::string& joint) {
    return std::ranges::find_if(changes, [&](const BallChange& change) {
      return change.joint == joint || change.joint == object.name + "_" + joint;
    });
  };
  for (model::Expectation& expectation : object.expectations) {
    for (auto& [joint, position] : expectation.positions) {
      if (const auto found = find(joint); found != changes.end()) Convert(*found, position);
    }
  }
  for (model::JointCheck& check : object.checks.joints) {
    for (auto& [joint, position] : check.positions) {
      const auto found = find(joint);
      if (found != changes.end() && position.size() == 4) Convert(*found, position);
    }
  }
}

// Moves the zero of a body's joints to their start, and the body to its pose at the start. Sets
// `ref` of hinges and slides, so that a number in qpos keeps its meaning. Removes the start of ball
// joints, because it becomes their zero.
void MoveZero(Body& body) {
  Pose X_LaterB;  // motion of the joints after joint i
  for (std::size_t i = body.joints.size(); i-- > 0;) {
    Joint& joint = body.joints[i];
    const Pose motion = model::JointMotion(joint, {}, joint.start);
    const Pose X_BLater = X_LaterB.Inverse();
    joint.pos = X_BLater * joint.pos;
    joint.axis = X_BLater.q * joint.axis;
    if (joint.type == "ball" && joint.start_velocity.size() == 3) {
      const Eigen::Vector3d velocity(joint.start_velocity.data());
      const Eigen::Vector3d turned = X_BLater.q * velocity;
      joint.start_velocity.assign(turned.begin(), turned.end());
    }
    X_LaterB = motion * X_LaterB;
    if (joint.start.empty()) continue;
    if (IsScalar(joint)) {
      SetNumbers(joint.attributes, "ref", joint.start);
    } else {
      joint.start.clear();
    }
  }
  body.X_PB = body.X_PB * X_LaterB;
}

}  // namespace

void MoveZeroToStart(model::Object& object) {
  if (!IsMoved(object)) return;
  const Configurations configurations(object);
  RewriteEqualities(configurations, object);
  RewriteTendons(configurations, object);
  RewriteViews(configurations, object);
  ConvertPositions(BallChanges(object), object);
  for (Body& body : object.bodies) {
    if (std::ranges::any_of(body.joints, model::HasStart)) MoveZero(body);
  }
}

}  // namespace mjforge::start
