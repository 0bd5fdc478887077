#ifndef MJFORGE_COMPILED_COMPILED_H_
#define MJFORGE_COMPILED_COMPILED_H_

// What MuJoCo compiled, in the words of the model.

#include <array>
#include <optional>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"

namespace mjforge::compiled {

/// MJCF's words for mjtJoint, in its order.
inline constexpr std::array<std::string_view, 4> kJointTypes = {"free", "ball", "slide", "hinge"};

/// The number `id` of a list of triples.
Eigen::Vector3d VectorAt(const mjtNum* array, int id);
/// The number `id` of a list of quaternions.
Eigen::Quaterniond QuaternionAt(const mjtNum* array, int id);
/// The number `id` of a list of positions and one of quaternions.
model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id);

/// Nothing for planes and height fields, which belong to scenes.
std::optional<model::GeomType> GeomTypeOf(int mjtgeom);

/// Whether a geom belongs to a body but the world and its bits let it collide.
bool CollidesInBody(const mjModel& m, int geom);

/// X_WG of a geom, as mj_kinematics left it.
model::Pose GeomPose(const mjData& d, int geom);

/// A mesh asset's surface in the frame of geoms that use it, m. MuJoCo keeps
/// vertices in single precision.
model::TriangleMesh MeshOf(const mjModel& m, int mesh);

/// The exact box around a geom at a pose. Empty for planes and height fields.
model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG);

/// The box around all that can collide where mj_kinematics left it, in the world frame; with a
/// `root` other than the world (0), of the bodies on that one alone.
model::Box3 CollidingBox(const mjModel& m, const mjData& d, int root);

}  // namespace mjforge::compiled

#endif  // MJFORGE_COMPILED_COMPILED_H_
