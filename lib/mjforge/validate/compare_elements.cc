// The parts of a body: geoms, joints, sites.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mjforge/validate/compare.h"

namespace mjforge::validate {
namespace {

constexpr double kRelative = 1e-9;
constexpr double kFloatRelative = 1e-6;  // of what MuJoCo keeps in single precision

constexpr int MujocoType(model::GeomType type) {
  switch (type) {
    case model::GeomType::kSphere:
      return mjGEOM_SPHERE;
    case model::GeomType::kCapsule:
      return mjGEOM_CAPSULE;
    case model::GeomType::kEllipsoid:
      return mjGEOM_ELLIPSOID;
    case model::GeomType::kCylinder:
      return mjGEOM_CYLINDER;
    case model::GeomType::kBox:
      return mjGEOM_BOX;
    case model::GeomType::kMesh:
      return mjGEOM_MESH;
  }
  return -1;
}

int MujocoJointType(std::string_view type) {
  if (type == "free") return mjJNT_FREE;
  if (type == "ball") return mjJNT_BALL;
  return type == "slide" ? mjJNT_SLIDE : mjJNT_HINGE;
}

/// Where a compiled geom keeps an attribute: one of the three arrays.
struct GeomField {
  std::string_view name;
  std::size_t count;  // numbers a geom
  mjtNum* mjModel::*numbers = nullptr;
  int* mjModel::*integers = nullptr;
  float* mjModel::*floats = nullptr;
};
constexpr GeomField kGeomFields[] = {
    {.name = "friction", .count = 3, .numbers = &mjModel::geom_friction},
    {.name = "solref", .count = 2, .numbers = &mjModel::geom_solref},
    {.name = "solimp", .count = 5, .numbers = &mjModel::geom_solimp},
    {.name = "solmix", .count = 1, .numbers = &mjModel::geom_solmix},
    {.name = "margin", .count = 1, .numbers = &mjModel::geom_margin},
    {.name = "gap", .count = 1, .numbers = &mjModel::geom_gap},
    {.name = "contype", .count = 1, .integers = &mjModel::geom_contype},
    {.name = "conaffinity", .count = 1, .integers = &mjModel::geom_conaffinity},
    {.name = "condim", .count = 1, .integers = &mjModel::geom_condim},
    {.name = "priority", .count = 1, .integers = &mjModel::geom_priority},
    {.name = "group", .count = 1, .integers = &mjModel::geom_group},
    {.name = "rgba", .count = 4, .floats = &mjModel::geom_rgba},
};

double Stored(const mjModel& m, const GeomField& field, std::size_t at) {
  if (field.numbers != nullptr) return (m.*field.numbers)[at];
  if (field.integers != nullptr) return (m.*field.integers)[at];
  return static_cast<double>((m.*field.floats)[at]);
}

/// The box around a compiled mesh geom in its body's frame.
model::Box3 MeshBox(const mjModel& m, int geom) {
  const mjtNum* p = m.geom_pos + 3 * geom;
  const mjtNum* q = m.geom_quat + 4 * geom;
  const model::Pose X_BG{{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
  const int mesh = m.geom_dataid[geom];
  model::Box3 box;
  for (int i = 0; i < m.mesh_vertnum[mesh]; ++i) {
    const float* v = m.mesh_vert + 3 * (m.mesh_vertadr[mesh] + i);
    const Eigen::Vector3d point =
        X_BG * Eigen::Vector3d(Eigen::Vector3f(v[0], v[1], v[2]).cast<double>());
    box.Add({point, point});
  }
  return box;
}

}  // namespace

void Comparison::ComparePart(int& geom, const model::Part& part) {
  if (part.role != model::Role::kVisual) {
    CompareGeom(geom++, part, {"geom", part.name, {}, part.mark}, true);
  }
  if (part.role != model::Role::kCollision) {
    CompareGeom(geom++, part, {"geom", part.name, mjcf::kVisualSuffix, part.mark}, false);
  }
}

void Comparison::CompareGeom(int id, const model::Part& part, const Subject& subject,
                             bool collides) {
  if (!Name(m_.names + m_.name_geomadr[id], subject)) return;
  const model::GeomType type = part.shape.type;
  Number(subject, "type", -1, m_.geom_type[id], MujocoType(type), 0);
  if (type == model::GeomType::kMesh) {
    if (m_.geom_type[id] == mjGEOM_MESH) CompareMesh(id, part, subject);
  } else {
    for (int i = 0; i < model::SizeCount(type); ++i) {
      Number(subject, "size", i, m_.geom_size[3 * id + i], part.shape.size[i],
             kRelative * part.shape.size[i]);
    }
    Vector(subject, "pos", m_.geom_pos + 3 * id, part.X_BG.p, length_tolerance_);
    Quaternion(subject, m_.geom_quat + 4 * id, part.X_BG.q);
  }
  if (!collides) {
    Number(subject, "contype", -1, m_.geom_contype[id], 0, 0);
    Number(subject, "conaffinity", -1, m_.geom_conaffinity[id], 0, 0);
  }
  const spec::Applies other = collides ? spec::Applies::kVisual : spec::Applies::kCollision;
  for (const model::Attribute& attribute : part.attributes) {
    const bool written =
        attribute.applies != other || (collides && part.role == model::Role::kCollision);
    if (written) CompareGeomAttribute(id, attribute, subject);
  }
}

/// MuJoCo moves a mesh's origin to its centre of mass and turns it to its
/// principal axes, so only where its vertices are can be compared.
void Comparison::CompareMesh(int id, const model::Part& part, const Subject& subject) {
  if (part.shape.mesh == nullptr) return;
  const model::Box3 compiled = MeshBox(m_, id);
  const model::Box3 meant = model::BoundsOf(part.shape, part.X_BG);
  const double tolerance = kFloatRelative * scale_;
  Vector(subject, "lower corner", compiled.min.data(), meant.min, tolerance);
  Vector(subject, "upper corner", compiled.max.data(), meant.max, tolerance);
}

void Comparison::CompareGeomAttribute(int id, const model::Attribute& attribute,
                                      const Subject& subject) {
  for (const GeomField& field : kGeomFields) {
    if (field.name != attribute.name) continue;
    const double relative = field.floats != nullptr ? kFloatRelative : kRelative;
    const std::size_t count = std::min(field.count, attribute.numbers.size());
    for (std::size_t i = 0; i < count; ++i) {
      const double meant = attribute.numbers[i];
      Number(subject, field.name, field.count == 1 ? -1 : static_cast<int>(i),
             Stored(m_, field, field.count * static_cast<std::size_t>(id) + i), meant,
             relative * std::abs(meant));
    }
    return;
  }
}

void Comparison::CompareJoint(int id, const model::Joint& joint) {
  const Subject subject{"joint", joint.name, {}, joint.mark};
  if (!Name(m_.names + m_.name_jntadr[id], subject)) return;
  Number(subject, "type", -1, m_.jnt_type[id], MujocoJointType(joint.type), 0);
  if (joint.type != "free") {
    Vector(subject, "pos", m_.jnt_pos + 3 * id, joint.pos, length_tolerance_);
    if (joint.type != "ball") {
      Vector(subject, "axis", m_.jnt_axis + 3 * id, joint.axis.normalized(), kRelative);
    }
    Number(subject, "limited", -1, m_.jnt_limited[id], joint.range ? 1 : 0, 0);
    for (int i = 0; joint.range && i < 2; ++i) {
      const double meant = (*joint.range)[i];
      Number(subject, "range", i, m_.jnt_range[2 * id + i], meant, kRelative * std::abs(meant));
    }
  }
  CompareJointAttributes(id, joint, subject);
}

void Comparison::CompareJointAttributes(int id, const model::Joint& joint, const Subject& subject) {
  const int dof = m_.jnt_dofadr[id];
  for (const model::Attribute& attribute : joint.attributes) {
    if (attribute.name == "springdamper") return;  // MuJoCo sets the two from it
  }
  for (const model::Attribute& attribute : joint.attributes) {
    const mjtNum* stored = nullptr;
    if (attribute.name == "stiffness") stored = m_.jnt_stiffness + id;
    if (attribute.name == "margin") stored = m_.jnt_margin + id;
    if (attribute.name == "damping") stored = m_.dof_damping + dof;
    if (attribute.name == "armature") stored = m_.dof_armature + dof;
    if (attribute.name == "frictionloss") stored = m_.dof_frictionloss + dof;
    if (stored == nullptr || attribute.numbers.empty()) continue;
    const double meant = attribute.numbers[0];
    Number(subject, attribute.name, -1, *stored, meant, kRelative * std::abs(meant));
  }
}

void Comparison::CompareSite(int id, const model::Site& site) {
  const Subject subject{"site", site.name, {}, site.mark};
  if (!Name(m_.names + m_.name_siteadr[id], subject)) return;
  Number(subject, "type", -1, m_.site_type[id], MujocoType(site.type), 0);
  for (int i = 0; i < model::SizeCount(site.type); ++i) {
    Number(subject, "size", i, m_.site_size[3 * id + i], site.size[i], kRelative * site.size[i]);
  }
  Vector(subject, "pos", m_.site_pos + 3 * id, site.X_BS.p, length_tolerance_);
  Quaternion(subject, m_.site_quat + 4 * id, site.X_BS.q);
}

}  // namespace mjforge::validate
