// Compiled models of MuJoCo, read into the types of room `model`.
#pragma once

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
/// Allocates the data of a model. Throws std::exception if there is not enough memory.
Data MakeData(const mjModel& m);

/// Returns the name of an element ("lid"), or its kind and id ("geom 3") if it has no name.
std::string NameOf(const mjModel& m, mjtObj kind, int id);

/// Joint types of MJCF, in the order of mjtJoint.
inline constexpr std::array<std::string_view, 4> kJointTypes = {"free", "ball", "slide", "hinge"};

/// The mjtGeom of each GeomType, in the order of GeomType.
inline constexpr std::array<int, 6> kGeomTypes = {mjGEOM_SPHERE,   mjGEOM_CAPSULE, mjGEOM_ELLIPSOID,
                                                  mjGEOM_CYLINDER, mjGEOM_BOX,     mjGEOM_MESH};

/// Converts an id of a body, geom, joint or degree of freedom to an index of a vector.
constexpr std::size_t Index(int id) { return static_cast<std::size_t>(id); }

/// Element `id` of an array of vectors.
Eigen::Vector3d VectorAt(const mjtNum* array, int id);
/// Element `id` of an array of quaternions.
Eigen::Quaterniond QuaternionAt(const mjtNum* array, int id);
/// Element `id` of an array of rotation matrices.
Eigen::Matrix3d MatrixAt(const mjtNum* array, int id);
/// Pose `id` from an array of positions and an array of quaternions.
model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id);
/// Writes a position and a quaternion.
void WritePose(const model::Pose& X, mjtNum* pos, mjtNum* quat);

/// Returns nothing for planes and height fields, which belong to scenes.
std::optional<model::GeomType> GeomTypeOf(int mjtgeom);

/// Returns true if a geom's contact bits let it collide.
bool Collides(const mjModel& m, int geom);

/// X_WG of a geom, as mj_kinematics computed it.
model::Pose GeomPose(const mjData& d, int geom);

/// Surface of a mesh asset in the frame of the geoms that use it, m. Vertices have single
/// precision.
model::TriangleMesh MeshOf(const mjModel& m, int mesh);

/// Exact bounding box of a geom at a pose. Empty for planes and height fields.
model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG);

/// Bounding box, in the world frame, of all colliding geoms at the poses that mj_kinematics
/// computed. If `root` is not the world (0), only of the geoms of the tree with that root.
model::Box3 CollidingBox(const mjModel& m, const mjData& d, int root);

/// Returns true for hinges and slides, whose position is one number of qpos.
bool HasOneNumber(const mjModel& m, int joint);

/// Possible positions of a joint, in terms of qpos, rad or m: its range, or a full turn about the
/// zero of an unlimited hinge. For a ball joint the angle from its zero; `low` is 0.
struct JointRange {
  bool limited = false;
  double low = 0;
  double high = 0;
};
/// Returns nothing for free joints and for slides without a range.
std::optional<JointRange> RangeOf(const mjModel& m, int joint);

/// Start positions of the joints, nq numbers: those of the keyframe with the model's name and
/// `_start`, which mjforge writes; without such a keyframe, qpos0.
std::span<const mjtNum> StartOf(const mjModel& m);

/// Copies positions, velocities, activations and controls at the start to `d`.
void CopyStart(const mjModel& m, mjData& d);

/// Returns the qpos of a ball joint that is rotated from its zero by an angle about an axis.
std::array<mjtNum, 4> BallAt(const mjModel& m, int joint, const Eigen::Vector3d& axis,
                             double angle);

/// Mass, centre of mass and inertia of a body, in its frame.
model::MassProperties MassOf(const mjModel& m, int body);

/// Reads a body without its joints and parts. Indices of bodies leave out the world, which is -1.
model::Body BodyOf(const mjModel& m, int id);
model::Joint JointOf(const mjModel& m, int id);
/// Reads a geom without its attributes and mass. A mesh has no surface; its pose is for that of
/// MeshOf(). Returns nothing for planes and height fields.
std::optional<model::Part> PartOf(const mjModel& m, int id);

/// Names of elements without a name: "", or those of NameOf().
enum class Nameless { kEmpty, kNumbered };
/// Reads the bodies with joints and parts as the functions above do, and also the `group` of parts.
/// Mass and bounds of the whole are in the world frame, at StartOf(). The bounds have only the box
/// around all colliding parts. All elements have the place `mark`.
model::Object ObjectOf(const mjModel& m, diag::SourceMark mark, Nameless nameless);

}  // namespace mjforge::compiled
