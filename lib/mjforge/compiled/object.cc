// Converts compiled models to model::Object: bodies, joints, parts and masses.
#include <new>

#include "mjforge/compiled/compiled.h"

namespace mjforge::compiled {
namespace {

void AddMeshes(const mjModel& m, model::Object& object) {
  for (int i = 0; i < m.nmesh; ++i) {
    object.meshes.push_back(std::make_unique<model::MeshAsset>());
    object.meshes.back()->name = m.names + m.name_meshadr[i];
    object.meshes.back()->mesh = MeshOf(m, i);
  }
}

void AddMass(const model::MassProperties& mass_W, model::MassProperties& sum) {
  if (mass_W.mass <= 0) return;
  sum = sum.mass > 0 ? model::Combine(sum, mass_W) : mass_W;
}

// If the model has the keyframe NAME_start, stores the start position of a joint in the last joint
// of `body`, and adds the attribute `ref` to a hinge or slide. The start pose of a free joint
// becomes the pose of the body. `id` is MuJoCo's id of the joint.
void SetStart(const mjModel& m, int id, model::Body& body) {
  const mjtNum* start = StartOf(m).data();
  if (start == m.qpos0) return;
  model::Joint& joint = body.joints.back();
  const int at = m.jnt_qposadr[id];
  if (joint.type == "free") {
    body.X_PB = PoseAt(start + at, start + at + 3, 0);
  } else if (joint.type == "ball") {
    joint.start.assign(start + at, start + at + 4);
  } else {
    joint.start = {start[at]};
    joint.attributes.push_back({.name = "ref", .numbers = {m.qpos0[at]}});
  }
}

}  // namespace

Data MakeData(const mjModel& m) {
  Data data(mj_makeData(&m));
  if (!data) throw std::bad_alloc();
  return data;
}

std::string NameOf(const mjModel& m, mjtObj kind, int id) {
  const char* name = mj_id2name(&m, kind, id);
  if (name != nullptr && *name != 0) return name;
  return std::string(mju_type2Str(kind)) + ' ' + std::to_string(id);
}

model::MassProperties MassOf(const mjModel& m, int body) {
  const Eigen::Matrix3d axes = QuaternionAt(m.body_iquat, body).toRotationMatrix();
  return {.mass = m.body_mass[body],
          .p_FCm = VectorAt(m.body_ipos, body),
          .I_Cm_F = axes * VectorAt(m.body_inertia, body).asDiagonal() * axes.transpose()};
}

model::Body BodyOf(const mjModel& m, int id) {
  model::Body body;
  body.name = m.names + m.name_bodyadr[id];
  body.parent = m.body_parentid[id] - 1;
  body.X_PB = PoseAt(m.body_pos, m.body_quat, id);
  body.explicit_inertial = true;
  body.mass_properties = MassOf(m, id);
  body.principal_axes = QuaternionAt(m.body_iquat, id);
  return body;
}

model::Joint JointOf(const mjModel& m, int id) {
  model::Joint joint;
  joint.name = m.names + m.name_jntadr[id];
  joint.type = kJointTypes[static_cast<std::size_t>(m.jnt_type[id])];
  joint.pos = VectorAt(m.jnt_pos, id);
  joint.axis = VectorAt(m.jnt_axis, id);
  if (m.jnt_limited[id] != 0) {
    joint.range = Eigen::Vector2d(m.jnt_range[2 * id], m.jnt_range[2 * id + 1]);
  }
  return joint;
}

std::optional<model::Part> PartOf(const mjModel& m, int id) {
  const std::optional<model::GeomType> type = GeomTypeOf(m.geom_type[id]);
  if (!type) return std::nullopt;
  model::Part part;
  part.name = m.names + m.name_geomadr[id];
  part.role = Collides(m, id) ? model::Role::kCollision : model::Role::kVisual;
  part.as_is = true;
  part.shape.type = *type;
  if (*type == model::GeomType::kMesh) part.mesh = m.geom_dataid[id];
  for (int i = 0; i < model::SizeCount(*type); ++i) part.shape.size[i] = m.geom_size[3 * id + i];
  part.X_BG = PoseAt(m.geom_pos, m.geom_quat, id);
  return part;
}

model::Object ObjectOf(const mjModel& m, diag::SourceMark mark, Nameless nameless) {
  model::Object object;
  object.name = m.names;  // `names` begins with the model's name
  AddMeshes(m, object);
  const auto set_name = [&](auto& element, mjtObj kind, int id) {
    element.mark = mark;
    if (nameless == Nameless::kNumbered) element.name = NameOf(m, kind, id);
  };
  for (int id = 1; id < m.nbody; ++id) {
    model::Body& body = object.bodies.emplace_back(BodyOf(m, id));
    set_name(body, mjOBJ_BODY, id);
    const int first_joint = m.body_jntadr[id];
    for (int i = first_joint; i < first_joint + m.body_jntnum[id]; ++i) {
      set_name(body.joints.emplace_back(JointOf(m, i)), mjOBJ_JOINT, i);
      SetStart(m, i, body);
    }
    const int first_geom = m.body_geomadr[id];
    for (int i = first_geom; i < first_geom + m.body_geomnum[id]; ++i) {
      std::optional<model::Part> part = PartOf(m, i);
      if (!part) continue;
      set_name(*part, mjOBJ_GEOM, i);
      part->attributes = {{.name = "group", .numbers = {double(m.geom_group[i])}}};
      if (part->mesh >= 0) {
        part->shape.mesh = &object.meshes[static_cast<std::size_t>(part->mesh)]->mesh;
      }
      body.parts.push_back(*std::move(part));
    }
  }
  const std::vector<model::Pose> X_WB = model::BodyPoses(object);
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const model::Body& body = object.bodies[i];
    AddMass(model::InFrame(X_WB[i], body.mass_properties), object.mass_properties);
    for (const model::Part& part : body.parts) {
      if (part.role == model::Role::kVisual) continue;
      object.bounds.aabb.Add(model::BoundsOf(part.shape, X_WB[i] * part.X_BG));
    }
  }
  return object;
}

}  // namespace mjforge::compiled
