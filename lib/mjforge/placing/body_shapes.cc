// Shapes, poses and masses of subtrees of an object.

#include "mjforge/placing/body_shapes.h"

#include <optional>

namespace mjforge::placing {
namespace {

const model::Body& BodyAt(const model::Object& object, int body) {
  return object.bodies[static_cast<std::size_t>(body)];
}

// Returns the pose X_AB of body B if B is body A or below A. Climbs from B to its parents, because
// the index of a body may be less than that of its parent: placing changes parents.
std::optional<model::Pose> PoseBelow(const model::Object& object, int a, int b) {
  if (b == a) return model::Pose();
  if (b < 0) return std::nullopt;
  std::optional<model::Pose> X_AB = PoseBelow(object, a, BodyAt(object, b).parent);
  if (X_AB) X_AB = *X_AB * model::StartPose(BodyAt(object, b));
  return X_AB;
}

// Calls visit(index, X_AB) for a body A and for each body B below A.
template <typename Visit>
void VisitBelow(const model::Object& object, int body, const Visit& visit) {
  for (int i = 0; i < static_cast<int>(object.bodies.size()); ++i) {
    if (const std::optional<model::Pose> X_AB = PoseBelow(object, body, i)) visit(i, *X_AB);
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
  const model::Pose X_PB = model::StartPose(of);
  return of.parent < 0 ? X_PB : PoseInWorld(object, of.parent) * X_PB;
}

}  // namespace mjforge::placing
