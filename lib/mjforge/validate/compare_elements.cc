// The parts of a body: geoms, joints, sites.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mjforge/compiled/compiled.h"
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

/// Where a compiled joint keeps an attribute.
enum class Index { kJoint, kDof, kQpos };
struct JointField {
  std::string_view name;
  std::size_t count;  // numbers a row
  Index index;
  mjtNum* mjModel::*numbers;
};
constexpr JointField kJointFields[] = {
    {"stiffness", 1, Index::kJoint, &mjModel::jnt_stiffness},
    {"margin", 1, Index::kJoint, &mjModel::jnt_margin},
    {"solreflimit", mjNREF, Index::kJoint, &mjModel::jnt_solref},
    {"solimplimit", mjNIMP, Index::kJoint, &mjModel::jnt_solimp},
    {"damping", 1, Index::kDof, &mjModel::dof_damping},
    {"armature", 1, Index::kDof, &mjModel::dof_armature},
    {"frictionloss", 1, Index::kDof, &mjModel::dof_frictionloss},
    {"solreffriction", mjNREF, Index::kDof, &mjModel::dof_solref},
    {"solimpfriction", mjNIMP, Index::kDof, &mjModel::dof_solimp},
    {"ref", 1, Index::kQpos, &mjModel::qpos0},
    {"springref", 1, Index::kQpos, &mjModel::qpos_spring},
};

double Stored(const mjModel& m, const GeomField& field, std::size_t at) {
  if (field.numbers != nullptr) return (m.*field.numbers)[at];
  if (field.integers != nullptr) return (m.*field.integers)[at];
  return static_cast<double>((m.*field.floats)[at]);
}

}  // namespace

void Comparison::ComparePart(int& geom, const model::Part& part) {
  if (part.as_is) {
    CompareGeom(geom++, part, {"geom", part.name, {}, part.mark},
                part.role != model::Role::kVisual);
    return;
  }
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
  const model::Applies other = collides ? model::Applies::kVisual : model::Applies::kCollision;
  for (const model::Attribute& attribute : part.attributes) {
    const bool written = part.as_is || attribute.applies != other ||
                         (collides && part.role == model::Role::kCollision);
    if (written) CompareGeomAttribute(id, attribute, subject);
  }
}

/// MuJoCo moves a mesh's origin to its centre of mass and turns it to its
/// principal axes, so only where its vertices are can be compared.
void Comparison::CompareMesh(int id, const model::Part& part, const Subject& subject) {
  if (part.shape.mesh == nullptr) return;
  const model::Box3 made =
      compiled::GeomBox(m_, id, compiled::PoseAt(m_.geom_pos, m_.geom_quat, id));
  const model::Box3 meant = model::BoundsOf(part.shape, part.X_BG);
  const double tolerance = kFloatRelative * scale_;
  Vector(subject, "lower corner", made.min.data(), meant.min, tolerance);
  Vector(subject, "upper corner", made.max.data(), meant.max, tolerance);
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
  const bool scalar = joint.type == "hinge" || joint.type == "slide";
  for (const model::Attribute& attribute : joint.attributes) {
    if (attribute.name == "springdamper") return;  // MuJoCo sets the two from it
  }
  for (const model::Attribute& attribute : joint.attributes) {
    for (const JointField& field : kJointFields) {
      if (field.name != attribute.name || (field.index == Index::kQpos && !scalar)) continue;
      const int row = field.index == Index::kJoint ? id
                      : field.index == Index::kDof ? m_.jnt_dofadr[id]
                                                   : m_.jnt_qposadr[id];
      const mjtNum* stored = m_.*field.numbers + field.count * static_cast<std::size_t>(row);
      const std::size_t count = std::min(field.count, attribute.numbers.size());
      for (std::size_t i = 0; i < count; ++i) {
        const double meant = attribute.numbers[i];
        Number(subject, field.name, field.count == 1 ? -1 : static_cast<int>(i), stored[i], meant,
               kRelative * std::abs(meant));
      }
    }
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
