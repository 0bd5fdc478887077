// Simulation of one pile, whose bodies fall one after the other into a region and come to rest.
#pragma once

#include <vector>

#include <mujoco/mujoco.h>
#include <Eigen/Dense>

#include "mjforge/model/model.h"

namespace mjforge::physics {

/// A body of a pile in the compiled model.
struct PiledBody {
  int id = 0;
  double radius = 0;                                // m, bounding sphere around the centre of mass
  Eigen::Vector3d p_BCm = Eigen::Vector3d::Zero();  // m, centre of mass of the body's tree
  const model::Pile::Item* release = nullptr;       // pile item with the pose of its release
};

/// Releases the bodies of one pile in the order of `bodies`, while all other bodies are held;
/// returns true if the bodies came to rest. `X_WR` is the pose of the region in the world. At the
/// end, restores the options and the damping of the model, but not the armature of held bodies.
bool SimulatePile(mjModel& m, mjData& d, const model::Pile& pile,
                  const std::vector<PiledBody>& bodies, const model::Pose& X_WR);

}  // namespace mjforge::physics
