// Reading of MuJoCo's compiled models into the types of the library `model`.
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

/// Converts an mjtGeom; nullopt for planes and height fields, which belong to scenes.
std::optional<model::GeomType> GeomTypeOf(int mjtgeom);

/// Returns true if a geom has any bit in contype or conaffinity.
bool Collides(const mjModel& m, int geom);

/// Returns X_WG of a geom, as computed by mj_kinematics.
model::Pose GeomPose(const mjData& d, int geom);

/// Returns the surface of a mesh asset in the frame of the geoms that use this mesh, m. Vertices
/// have single precision.
model::TriangleMesh MeshOf(const mjModel& m, int mesh);

/// Returns the exact bounding box, in frame A, of a geom at the pose `X_AG`. The box is empty for
/// planes and height fields.
model::Box3 GeomBox(const mjModel& m, int geom, const model::Pose& X_AG);

/// Returns the bounding box, in the world frame, of all colliding geoms at the poses that
/// mj_kinematics computed. If `root` is not the world (0), only geoms in the tree of the body
/// `root` count.
model::Box3 CollidingBox(const mjModel& m, const mjData& d, int root);

/// Returns true for hinges and slides, whose position is one number of qpos.
bool HasOneNumber(const mjModel& m, int joint);

/// Possible positions of a joint, as in qpos, rad or m: the joint's range, or a full turn about the
/// reference position (qpos0) of an unlimited hinge. For a ball joint, `low` is 0, and `high` is
/// the largest angle from the reference orientation (qpos0).
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

/// Copies positions, velocities, activations and controls at the start to `d`.
void CopyStart(const mjModel& m, mjData& d);

/// Returns the qpos of a ball joint that is rotated from its reference orientation (qpos0) by an
/// angle, rad, about a unit vector.
std::array<mjtNum, 4> BallAt(const mjModel& m, int joint, const Eigen::Vector3d& axis,
                             double angle);

/// Returns mass, centre of mass and inertia of a body, in the body's frame.
model::MassProperties MassOf(const mjModel& m, int body);

/// Reads a body without its joints and without its geoms (Body::parts). Body::parent is MuJoCo's id
/// minus 1, so that the world is -1.
model::Body BodyOf(const mjModel& m, int id);
model::Joint JointOf(const mjModel& m, int id);
/// Reads a geom without its attributes and mass. A mesh geom has no Shape::mesh; its pose is the
/// pose of the surface from MeshOf(). Returns nullopt for planes and height fields.
std::optional<model::Part> PartOf(const mjModel& m, int id);

/// Names given to elements that have no name: empty, or the result of NameOf().
enum class Nameless { kEmpty, kNumbered };
/// Reads all bodies with BodyOf(), their joints, and their parts with PartOf(), and also the
/// `group` of parts. Mass and bounds of the object are in the world frame, at StartOf(). The bounds
/// contain only `aabb`, the box around all colliding parts. All elements get the source mark
/// `mark`.
model::Object ObjectOf(const mjModel& m, diag::SourceMark mark, Nameless nameless);

}  // namespace mjforge::compiled
