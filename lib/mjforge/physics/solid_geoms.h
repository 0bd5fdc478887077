// Colliding geoms that have an inside, and rays to them.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>

namespace mjforge::physics {

/// Returns true for a colliding geom that is neither a plane nor a height field.
bool IsSolid(const mjModel& m, int geom);

/// Returns the distance to the surface of a solid geom along a ray, m; -1 if the ray misses the
/// geom. The ray begins at `from`; `way` is its direction, a unit vector; these
/// vectors are in the world frame. Needs the poses that mj_kinematics computes.
double RayTo(const mjModel& m, const mjData& d, int geom, const Eigen::Vector3d& from,
             const Eigen::Vector3d& way);

}  // namespace mjforge::physics
