#include "mjforge/validate/describe.h"

#include <cstddef>
#include <string_view>
#include <vector>

#include "mjforge/compiled/compiled.h"

namespace mjforge::validate {
namespace {

using compiled::PoseAt;

/// X_WB of every body with the joints at their reference; parents come first.
std::vector<model::Pose> BodyPoses(const mjModel& m) {
  std::vector<model::Pose> poses(static_cast<std::size_t>(m.nbody));
  for (int i = 1; i < m.nbody; ++i) {
    poses[static_cast<std::size_t>(i)] =
        poses[static_cast<std::size_t>(m.body_parentid[i])] * PoseAt(m.body_pos, m.body_quat, i);
  }
  return poses;
}

model::MassProperties MassOfBody(const mjModel& m, int id) {
  const model::Pose X_BI = PoseAt(m.body_ipos, m.body_iquat, id);
  model::MassProperties properties;
  properties.mass = m.body_mass[id];
  properties.I_Cm_F = Eigen::Map<const Eigen::Vector3d>(m.body_inertia + 3 * id).asDiagonal();
  return model::InFrame(X_BI, properties);
}

void DescribeJoints(const mjModel& m, CompiledModel& described) {
  for (int i = 0; i < m.njnt; ++i) {
    CompiledModel::Joint& joint = described.joints.emplace_back();
    joint.name = m.names + m.name_jntadr[i];
    joint.body = m.names + m.name_bodyadr[m.jnt_bodyid[i]];
    joint.type = compiled::kJointTypes[static_cast<std::size_t>(m.jnt_type[i])];
    joint.limited = m.jnt_limited[i] != 0;
    joint.range = Eigen::Map<const Eigen::Vector2d>(m.jnt_range + 2 * i);
    joint.axis = Eigen::Map<const Eigen::Vector3d>(m.jnt_axis + 3 * i);
  }
}

/// The names of what stands beside the bodies.
void DescribeElements(const mjModel& m, CompiledModel& described) {
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
      described.elements.push_back({std::string(kind.kind), m.names + kind.names[i]});
    }
  }
}

}  // namespace

CompiledModel Describe(const mjModel& m) {
  CompiledModel described;
  described.name = m.names;  // the model's name is the first
  described.geoms = m.ngeom;
  described.sites = m.nsite;
  const std::vector<model::Pose> poses = BodyPoses(m);
  for (int i = 1; i < m.nbody; ++i) {
    CompiledModel::Body& body = described.bodies.emplace_back();
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
    described.mass_properties = described.mass_properties.mass > 0
                                    ? model::Combine(described.mass_properties, in_world)
                                    : in_world;
  }
  DescribeJoints(m, described);
  DescribeElements(m, described);
  for (int i = 0; i < m.ngeom; ++i) {
    if (!compiled::CollidesInBody(m, i)) continue;
    const model::Pose X_WG =
        poses[static_cast<std::size_t>(m.geom_bodyid[i])] * PoseAt(m.geom_pos, m.geom_quat, i);
    described.aabb.Add(compiled::GeomBox(m, i, X_WG));
  }
  return described;
}

}  // namespace mjforge::validate
