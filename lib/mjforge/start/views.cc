// Cameras and lights that follow their body without turning with it (modes `track`, `trackcom`).
#include <cstddef>

#include "mjforge/start/rewriting.h"

namespace mjforge::start {
namespace {

using model::Element;
using model::Pose;

// Returns the centre of mass of each body and everything below it, in the world frame.
std::vector<Eigen::Vector3d> CentresOfMass(const std::vector<model::Body>& bodies,
                                           const Poses& X_WB) {
  std::vector<double> masses(bodies.size());
  std::vector<Eigen::Vector3d> moments(bodies.size(), Eigen::Vector3d::Zero());
  for (std::size_t i = bodies.size(); i-- > 0;) {
    const model::MassProperties& own = bodies[i].mass_properties;
    masses[i] += own.mass;
    moments[i] += own.mass * (X_WB[i] * own.p_FCm);
    if (bodies[i].parent < 0) continue;
    masses[static_cast<std::size_t>(bodies[i].parent)] += masses[i];
    moments[static_cast<std::size_t>(bodies[i].parent)] += moments[i];
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    moments[i] = masses[i] > 0 ? Eigen::Vector3d(moments[i] / masses[i]) : X_WB[i].p;
  }
  return moments;
}

// Rewrites the pose of a camera or light that follows a point without turning with its body. With
// the body at `after`, the orientation in the world and the offset from the followed point, along
// the axes of the world, are those that the element had with the body at `before`.
void Move(const Pose& before, const Eigen::Vector3d& followed_before, const Pose& after,
          const Eigen::Vector3d& followed_after, Element& view) {
  const Eigen::Quaterniond turn = (after.q.conjugate() * before.q).normalized();
  const Eigen::Vector3d offset = before * VectorOf(view, "pos") - followed_before;
  const Eigen::Vector3d p = after.Inverse() * Eigen::Vector3d(offset + followed_after);
  SetNumbers(view.attributes, "pos", p);
  if (view.tag == "light") {
    const Eigen::Vector3d dir = turn * VectorOf(view, "dir", -Eigen::Vector3d::UnitZ());
    SetNumbers(view.attributes, "dir", dir);
    return;
  }
  const Eigen::Quaterniond q = (turn * QuaternionOf(view)).normalized();
  SetNumbers(view.attributes, "quat", model::Wxyz(q));
}

}  // namespace

void RewriteViews(const Configurations& configurations, model::Object& object) {
  const std::vector<Eigen::Vector3d> zero = CentresOfMass(object.bodies, configurations.zero());
  const std::vector<Eigen::Vector3d> start = CentresOfMass(object.bodies, configurations.start());
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const Pose& before = configurations.zero()[i];
    const Pose& after = configurations.start()[i];
    for (Element& view : object.bodies[i].elements) {
      const std::string_view mode = TextOf(view, "mode");
      if (mode == "track") Move(before, before.p, after, after.p, view);
      if (mode == "trackcom") Move(before, zero[i], after, start[i], view);
    }
  }
}

}  // namespace mjforge::start
