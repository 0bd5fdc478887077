#include "mjforge/validate/describe.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace mjforge::validate {
namespace {

model::Pose PoseAt(const mjtNum* pos, const mjtNum* quat, int id) {
  const mjtNum* p = pos + 3 * id;
  const mjtNum* q = quat + 4 * id;
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

/// X_WB of every body with the joints at their reference; parents come first.
std::vector<model::Pose> BodyPoses(const mjModel& m) {
  std::vector<model::Pose> poses(static_cast<std::size_t>(m.nbody));
  for (int i = 1; i < m.nbody; ++i) {
    poses[static_cast<std::size_t>(i)] =
        poses[static_cast<std::size_t>(m.body_parentid[i])] * PoseAt(m.body_pos, m.body_quat, i);
  }
  return poses;
}

std::string_view JointType(int type) {
  switch (type) {
    case mjJNT_FREE:
      return "free";
    case mjJNT_BALL:
      return "ball";
    case mjJNT_SLIDE:
      return "slide";
    default:
      return "hinge";
  }
}

/// Empty for planes and height fields, which belong to scenes.
model::Box3 GeomBox(const mjModel& m, int id, const model::Pose& X_WG) {
  model::Shape shape;
  shape.size = Eigen::Map<const Eigen::Vector3d>(m.geom_size + 3 * id);
  model::Box3 box;
  switch (m.geom_type[id]) {
    case mjGEOM_SPHERE:
      shape.type = model::GeomType::kSphere;
      break;
    case mjGEOM_CAPSULE:
      shape.type = model::GeomType::kCapsule;
      break;
    case mjGEOM_ELLIPSOID:
      shape.type = model::GeomType::kEllipsoid;
      break;
    case mjGEOM_CYLINDER:
      shape.type = model::GeomType::kCylinder;
      break;
    case mjGEOM_BOX:
      shape.type = model::GeomType::kBox;
      break;
    case mjGEOM_MESH: {
      const int mesh = m.geom_dataid[id];
      for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) {
        const float* v = m.mesh_vert + 3 * (m.mesh_vertadr[mesh] + i);
        const Eigen::Vector3d p =
            X_WG * Eigen::Vector3d(Eigen::Vector3f(v[0], v[1], v[2]).cast<double>());
        box.Add({p, p});
      }
      return box;
    }
    default:
      return box;
  }
  return model::BoundsOf(shape, X_WG);
}

model::MassProperties MassOfBody(const mjModel& m, int id) {
  const model::Pose X_BI = PoseAt(m.body_ipos, m.body_iquat, id);
  model::MassProperties properties;
  properties.mass = m.body_mass[id];
  properties.I_Cm_F = Eigen::Map<const Eigen::Vector3d>(m.body_inertia + 3 * id).asDiagonal();
  return model::InFrame(X_BI, properties);
}

void DescribeJoints(const mjModel& m, CompiledModel& compiled) {
  for (int i = 0; i < m.njnt; ++i) {
    CompiledModel::Joint& joint = compiled.joints.emplace_back();
    joint.name = m.names + m.name_jntadr[i];
    joint.body = m.names + m.name_bodyadr[m.jnt_bodyid[i]];
    joint.type = JointType(m.jnt_type[i]);
    joint.limited = m.jnt_limited[i] != 0;
    joint.range = Eigen::Map<const Eigen::Vector2d>(m.jnt_range + 2 * i);
    joint.axis = Eigen::Map<const Eigen::Vector3d>(m.jnt_axis + 3 * i);
  }
}

}  // namespace

CompiledModel Describe(const mjModel& m) {
  CompiledModel compiled;
  compiled.name = m.names;  // the model's name is the first
  compiled.geoms = m.ngeom;
  compiled.sites = m.nsite;
  const std::vector<model::Pose> poses = BodyPoses(m);
  for (int i = 1; i < m.nbody; ++i) {
    CompiledModel::Body& body = compiled.bodies.emplace_back();
    body.name = m.names + m.name_bodyadr[i];
    body.parent = m.names + m.name_bodyadr[m.body_parentid[i]];
    body.mass = m.body_mass[i];
    body.inertia = Eigen::Map<const Eigen::Vector3d>(m.body_inertia + 3 * i);
    body.geoms = m.body_geomnum[i];
    if (body.mass <= 0) continue;
    const model::MassProperties in_world =
        model::InFrame(poses[static_cast<std::size_t>(i)], MassOfBody(m, i));
    compiled.mass_properties = compiled.mass_properties.mass > 0
                                   ? model::Combine(compiled.mass_properties, in_world)
                                   : in_world;
  }
  DescribeJoints(m, compiled);
  for (int i = 0; i < m.ngeom; ++i) {
    const int body = m.geom_bodyid[i];
    if (body == 0 || (m.geom_contype[i] == 0 && m.geom_conaffinity[i] == 0)) continue;
    const model::Pose X_WG =
        poses[static_cast<std::size_t>(body)] * PoseAt(m.geom_pos, m.geom_quat, i);
    compiled.aabb.Add(GeomBox(m, i, X_WG));
  }
  return compiled;
}

}  // namespace mjforge::validate
