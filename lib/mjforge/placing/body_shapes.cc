// Shapes, poses and masses of subtrees of an object.

#include "mjforge/placing/body_shapes.h"

#include <algorithm>
#include <optional>

namespace mjforge::placing {
namespace {

const model::Body& BodyAt(const model::Object& object, int body) {
  return object.bodies[static_cast<std::size_t>(body)];
}

// Returns the pose of a body in its parent, with its joints at their start.
model::Pose StartPose(const model::Body& body) {
  model::Pose X_PB = body.X_PB;
  for (const model::Joint& joint : body.joints) {
    if (!joint.start.empty()) X_PB = X_PB * model::JointMotion(joint, {}, joint.start);
  }
  return X_PB;
}

// Calls visit(index, X_AB) for a body A and for all bodies below it. Parents come before their
// children.
template <typename Visit>
void VisitBelow(const model::Object& object, int body, const Visit& visit) {
  std::vector<std::optional<model::Pose>> X_AB(object.bodies.size());
  X_AB[static_cast<std::size_t>(body)] = model::Pose();
  visit(body, model::Pose());
  for (int i = body + 1; i < static_cast<int>(object.bodies.size()); ++i) {
    const int parent = BodyAt(object, i).parent;
    if (parent < body || !X_AB[static_cast<std::size_t>(parent)]) continue;
    model::Pose& X = X_AB[static_cast<std::size_t>(i)].emplace(
        *X_AB[static_cast<std::size_t>(parent)] * StartPose(BodyAt(object, i)));
    visit(i, X);
  }
}

}  // namespace

std::vector<BodyShape> ShapesBelow(const model::Object& object, int body) {
  std::vector<BodyShape> colliding;
  std::vector<BodyShape> visual;
  VisitBelow(object, body, [&](int index, const model::Pose& X_AB) {
    for (const model::Part& part : BodyAt(object, index).parts) {
      auto& shapes = part.role == model::Role::kVisual ? visual : colliding;
      shapes.push_back({index, part.shape, X_AB * part.X_BG});
    }
  });
  return colliding.empty() ? visual : colliding;
}

model::MassProperties MassBelow(const model::Object& object, int body) {
  model::MassProperties sum;
  VisitBelow(object, body, [&](int index, const model::Pose& X_AB) {
    sum = model::Combine(sum, model::InFrame(X_AB, BodyAt(object, index).mass_properties));
  });
  return sum;
}

model::Pose PoseInWorld(const model::Object& object, int body) {
  const model::Body& of = BodyAt(object, body);
  const model::Pose X_PB = StartPose(of);
  return of.parent < 0 ? X_PB : PoseInWorld(object, of.parent) * X_PB;
}

}  // namespace mjforge::placing
