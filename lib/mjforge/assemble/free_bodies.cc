// Makes bodies with free joints children of the world.

#include "mjforge/assemble/free_bodies.h"

#include <fmt/format.h>

#include "mjforge/model/model.h"

namespace mjforge::assemble {
namespace {

// Returns the nearest ancestor that has joints but no free joint; null if there is none.
const model::Body* MovingParent(const std::vector<model::Body>& bodies, int parent) {
  for (; parent >= 0; parent = bodies[static_cast<std::size_t>(parent)].parent) {
    const model::Body& body = bodies[static_cast<std::size_t>(parent)];
    if (!body.joints.empty() && model::FreeJointOf(body) == nullptr) return &body;
  }
  return nullptr;
}

bool MayBeFree(const std::vector<model::Body>& bodies, const model::Body& body,
               const model::Joint& joint, diag::Findings& findings) {
  const diag::SourceMark mark = joint.mark ? joint.mark : body.mark;
  if (body.joints.size() > 1) {
    findings.Add(diag::Code::kModelBadValue, mark,
                 fmt::format("free joint '{}' is not the only joint of its body", joint.name),
                 "a free joint already allows every motion");
    return false;
  }
  const model::Body* moving = MovingParent(bodies, body.parent);
  // A body with `place:` may be on a moving support, because it stands on the support only at the
  // start.
  if (moving == nullptr || !body.place_name.empty()) return true;
  findings
      .Add(diag::Code::kModelBadValue, mark,
           fmt::format("body '{}' is free, but stands on body '{}', which moves", body.name,
                       moving->name),
           "a free body is one of the world: its parent may be fixed to the root, or free itself")
      .notes.push_back(
          {moving->joints.front().mark, fmt::format("'{}' moves by this joint", moving->name)});
  return false;
}

}  // namespace

void ReleaseFreeBodies(std::vector<model::Body>& bodies, diag::Findings& findings) {
  std::vector<std::size_t> released;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const model::Joint* joint = model::FreeJointOf(bodies[i]);
    if (joint == nullptr || !MayBeFree(bodies, bodies[i], *joint, findings)) continue;
    if (i > 0) released.push_back(i);  // the root already is a child of the world
  }
  if (released.empty()) return;
  const std::vector<model::Pose> X_WB = model::SubtreePoses(bodies, 0);
  for (const std::size_t i : released) {
    bodies[i].parent = -1;
    if (sample::Numbers& velocity = bodies[i].joints[0].start_velocity; !velocity.empty()) {
      Eigen::Map<Eigen::Vector3d> linear(velocity.data());
      linear = X_WB[i].q * (bodies[i].X_PB.q.conjugate() * linear);
    }
    bodies[i].X_PB = X_WB[i];
  }
}

}  // namespace mjforge::assemble
