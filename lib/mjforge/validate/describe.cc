#include "mjforge/validate/describe.h"

#include <cstddef>
#include <string_view>
#include <vector>

#include "mjforge/validate/geoms.h"

namespace mjforge::validate {
namespace {

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

/// The names of what stands beside the bodies.
void DescribeElements(const mjModel& m, CompiledModel& compiled) {
  struct Kind {
    std::string_view kind;
    const int* names;
    int count;
  };
  const Kind kinds[] = {
      {"camera", m.name_camadr, m.ncam},      {"light", m.name_lightadr, m.nlight},
      {"pair", m.name_pairadr, m.npair},      {"exclude", m.name_excludeadr, m.nexclude},
      {"equality", m.name_eqadr, m.neq},      {"tendon", m.name_tendonadr, m.ntendon},
      {"actuator", m.name_actuatoradr, m.nu}, {"sensor", m.name_sensoradr, m.nsensor}};
  for (const Kind& kind : kinds) {
    for (int i = 0; i < kind.count; ++i) {
      compiled.elements.push_back({std::string(kind.kind), m.names + kind.names[i]});
    }
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
    body.X_PB = PoseAt(m.body_pos, m.body_quat, i);
    body.mass_properties = MassOfBody(m, i);
    if (body.mass <= 0) continue;
    const model::MassProperties in_world =
        model::InFrame(poses[static_cast<std::size_t>(i)], body.mass_properties);
    compiled.mass_properties = compiled.mass_properties.mass > 0
                                   ? model::Combine(compiled.mass_properties, in_world)
                                   : in_world;
  }
  DescribeJoints(m, compiled);
  DescribeElements(m, compiled);
  for (int i = 0; i < m.ngeom; ++i) {
    if (!CollidesInBody(m, i)) continue;
    const model::Pose X_WG =
        poses[static_cast<std::size_t>(m.geom_bodyid[i])] * PoseAt(m.geom_pos, m.geom_quat, i);
    compiled.aabb.Add(GeomBox(m, i, X_WG));
  }
  return compiled;
}

}  // namespace mjforge::validate
