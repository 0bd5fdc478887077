// Reads compiled models (mjModel and mjData) into the types of mjforge::model, such as bodies,
// joints, parts and bounding boxes.
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
/// Allocates mjData for a model. Throws std::exception if there is not enough memory.
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

/// Returns vector `id` of an array of vectors.
Eigen::Vector3d VectorAt(const mjtNum* array, int id);
/// Returns quaternion `id` of an array of quaternions.
Eigen::Quaterniond QuaternionAt(const mjtNum* array, int id);
/// Returns matrix `id` of an array of rotation matrices.
Eigen::Matrix3d MatrixAt(const mjtNum* array, int id);
/// Returns pose `id` from an array of positions and an array of quaternions.
model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id);
/// Writes the pose X to `pos` (3 numbers) and `quat` (4 numbers, w first).
void WritePose(const model::Pose& X, mjtNum* pos, mjtNum* quat);

/// Returns the GeomType of an mjtGeom; nullopt for planes, height fields, and other types that only
/// scenes contain.
std::optional<model::GeomType> GeomTypeOf(int mjtgeom);

/// Returns true if a geom has any bit in contype or conaffinity.
bool Collides(const mjModel& m, int geom);

/// Computes from qpos the poses of bodies, geoms and sites, and the centres of mass of subtrees.
inline void UpdatePoses(const mjModel& m, mjData& d) {
  mj_kinematics(&m, &d);
  mj_comPos(&m, &d);
}

/// Returns X_WG, the pose of a geom in the world, as computed by mj_kinematics.
model::Pose GeomPose(const mjData& d, int geom);

/// Returns the triangles of a compiled mesh, m, in the frame of the geoms that use the mesh.
/// Vertices have single precision.
model::TriangleMesh MeshOf(const mjModel& m, int mesh);

/// Returns the smallest box with the axes of frame A around a geom; `X_AG` is the pose of the geom
/// in A. The box is empty for planes and height fields.
model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG);

/// Returns the bounding box, in the world frame, of colliding geoms at the poses that mj_kinematics
/// computed: of all geoms if `root` is 0 (the world), otherwise of the geoms in the tree of bodies
/// whose root is `root`.
model::Box3 CollidingBox(const mjModel& m, const mjData& d, int root);

/// Returns true for hinges and slides, whose position is a single number of qpos.
bool HasOneNumber(const mjModel& m, int joint);

/// Returns 1 + the last id of a body's subtree. A subtree has consecutive ids, because MuJoCo
/// numbers bodies depth first.
int SubtreeEnd(const mjModel& m, int body);

/// Returns true if the joint moves the body; false if `body` is not the id of a body.
bool Moves(const mjModel& m, int joint, int body);

/// Range of a joint's position in qpos, rad or m. A hinge without a range has one full turn, from
/// half a turn below to half a turn above its reference position (qpos0). For a ball joint, `low`
/// is 0, and `high` is the largest angle from the reference orientation (qpos0), pi if the joint
/// has no range.
struct JointRange {
  bool limited = false;
  double low = 0;
  double high = 0;
};
/// Returns the range of a joint; nullopt for free joints and for slides without a range.
std::optional<JointRange> RangeOf(const mjModel& m, int joint);

/// Returns the start positions of the joints, nq numbers: the qpos of the keyframe NAME_start that
/// mjforge writes (NAME is the model's name), or qpos0 if there is no such keyframe.
std::span<const mjtNum> StartOf(const mjModel& m);

/// Copies StartOf() to the positions in `d`. If the model has the keyframe NAME_start, also copies
/// the velocities, activations and controls of this keyframe.
void CopyStart(const mjModel& m, mjData& d);

/// Returns the qpos of a ball joint that is rotated from its reference orientation (qpos0) by an
/// angle, rad, about a unit vector.
std::array<mjtNum, 4> BallAt(const mjModel& m, int joint, const Eigen::Vector3d& axis,
                             double angle);

/// Returns mass, centre of mass, and inertia about the centre of mass of a body, in the body's
/// frame.
model::MassProperties MassOf(const mjModel& m, int body);

/// Reads a body, but neither joints nor geoms (Body::parts) of the body. Body::parent is MuJoCo's
/// id of the parent minus 1; -1 is the world.
model::Body BodyOf(const mjModel& m, int id);
/// Reads name, type, anchor, axis and range of a joint, but neither its start nor its attributes.
model::Joint JointOf(const mjModel& m, int id);
/// Reads name, role, shape and pose of a geom, but not its attributes and mass. For a mesh geom,
/// Part::mesh is the id of the mesh, Shape::mesh is null, and the pose is that of the triangles
/// from MeshOf(). Returns nullopt for planes and height fields.
std::optional<model::Part> PartOf(const mjModel& m, int id);

/// Name of an element that has no name in the model: an empty text, or the result of NameOf().
enum class Nameless { kEmpty, kNumbered };
/// Reads all bodies with BodyOf(), their joints with JointOf(), and their geoms with PartOf(), and
/// adds the attribute `group` to each part. Mass and bounds of the object are in the world frame,
/// at the start position (StartOf). The only bounds are `aabb`, the box around all colliding parts.
/// All bodies, joints and parts get the source mark `mark`.
model::Object ObjectOf(const mjModel& m, diag::SourceMark mark, Nameless nameless);

}  // namespace mjforge::compiled
