#pragma once

// What MuJoCo compiled, as types of `model`.

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <mujoco/mujoco.h>

#include "mjforge/compiled/attributes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::compiled {

struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using Data = std::unique_ptr<mjData, DeleteData>;
/// Throws std::exception if there is not enough memory.
Data MakeData(const mjModel& m);

/// "lid", or "geom 3" if it has no name.
std::string NameOf(const mjModel& m, mjtObj kind, int id);

/// MJCF's words for mjtJoint, in its order.
inline constexpr std::array<std::string_view, 4> kJointTypes = {"free", "ball", "slide", "hinge"};

/// mjtGeom of each GeomType, in its order.
inline constexpr std::array<int, 6> kGeomTypes = {mjGEOM_SPHERE,   mjGEOM_CAPSULE, mjGEOM_ELLIPSOID,
                                                  mjGEOM_CYLINDER, mjGEOM_BOX,     mjGEOM_MESH};

/// Triple number `id` of a list.
Eigen::Vector3d VectorAt(const mjtNum* array, int id);
/// Quaternion number `id` of a list.
Eigen::Quaterniond QuaternionAt(const mjtNum* array, int id);
/// Pose number `id`, from a list of positions and a list of quaternions.
model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id);

/// Nothing for planes and height fields, which belong to scenes.
std::optional<model::GeomType> GeomTypeOf(int mjtgeom);

/// Whether a geom's bits let it collide.
bool Collides(const mjModel& m, int geom);

/// X_WG of a geom, as mj_kinematics left it.
model::Pose GeomPose(const mjData& d, int geom);

/// A mesh asset's surface in the frame of geoms that use it, m. MuJoCo keeps
/// vertices in single precision.
model::TriangleMesh MeshOf(const mjModel& m, int mesh);

/// The exact box around a geom at a pose. Empty for planes and height fields.
model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG);

/// The box around all geoms that can collide, posed by mj_kinematics, in the world frame; with a
/// `root` other than the world (0), only of that body of the world and the bodies on it.
model::Box3 CollidingBox(const mjModel& m, const mjData& d, int root);

/// Whether one number of qpos says where it stands: a hinge or slide.
bool HasOneNumber(const mjModel& m, int joint);

/// Where a joint can stand, as qpos has it, rad or m: its range, or a full turn about the zero of
/// an unlimited hinge. Of a ball joint the angle from its zero, from 0 up.
struct JointRange {
  bool limited = false;
  double low = 0;
  double high = 0;
};
/// Nothing for free joints and for slides without a range.
std::optional<JointRange> RangeOf(const mjModel& m, int joint);

/// Where the joints stand at the start, nq numbers: in the keyframe that is named as the model and
/// `_start`, as mjforge writes it; without one, qpos0.
std::span<const mjtNum> StartOf(const mjModel& m);

/// The qpos of a ball joint that is turned from its zero.
std::array<mjtNum, 4> BallAt(const mjModel& m, int joint, const Eigen::Vector3d& axis,
                             double angle);

/// Mass, centre and inertia of a body, in its frame.
model::MassProperties MassOf(const mjModel& m, int body);

/// A body without joints and parts. The numbers of bodies leave out the world: it is -1.
model::Body BodyOf(const mjModel& m, int id);
model::Joint JointOf(const mjModel& m, int id);
/// Without attributes, mass and, of a mesh, its surface: the pose is that of MeshOf(). Nothing
/// for planes and height fields.
std::optional<model::Part> PartOf(const mjModel& m, int id);

enum class Nameless { kEmpty, kNumbered };  // "", or what NameOf() says
/// The bodies with joints and parts, as above, and the parts' `group`. Mass and bounds of the whole
/// are in the world frame, at the joints' zero; of the bounds only the box is there, around all
/// that can collide. Findings are to point at `mark`.
model::Object ObjectOf(const mjModel& m, diag::SourceMark mark, Nameless nameless);

}  // namespace mjforge::compiled
