// Comparison of compiled geoms, joints and sites with those of the object.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "mjforge/compiled/compiled.h"
#include "mjforge/validate/compare.h"

namespace mjforge::validate {
namespace {

constexpr double kFloatRelative = 1e-6;  // tolerance of numbers in single precision

int MujocoType(model::GeomType type) {
  return compiled::kGeomTypes[static_cast<std::size_t>(type)];
}

}  // namespace

void Comparison::ComparePart(int& geom, const model::Part& part) {
  const bool collides = part.role != model::Role::kVisual;
  if (collides || part.as_is) {
    CompareGeom(geom++, part, {"geom", part.name, {}, part.mark}, collides);
  }
  if (part.role != model::Role::kCollision && !part.as_is) {
    CompareGeom(geom++, part, {"geom", part.name, model::kVisualSuffix, part.mark}, false);
  }
}

void Comparison::CompareGeom(int id, const model::Part& part, const ComparedElement& subject,
                             bool collides) {
  if (!SameName(m_.names + m_.name_geomadr[id], subject, findings_)) return;
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
    if (written) CompareAttribute(mjOBJ_GEOM, id, attribute, subject);
  }
}

/// Compares the bounding boxes of the vertices, because MuJoCo moves a mesh's origin to its centre
/// of mass and aligns its frame with its principal axes.
void Comparison::CompareMesh(int id, const model::Part& part, const ComparedElement& subject) {
  if (part.shape.mesh == nullptr) return;
  const model::Box3 made =
      compiled::GeomBox(m_, id, compiled::PoseAt(m_.geom_pos, m_.geom_quat, id));
  const model::Box3 meant = model::BoundsOf(part.shape, part.X_BG);
  const double tolerance = kFloatRelative * scale_;
  Vector(subject, "lower corner", made.min.data(), meant.min, tolerance);
  Vector(subject, "upper corner", made.max.data(), meant.max, tolerance);
}

void Comparison::CompareAttribute(mjtObj kind, int id, const model::Attribute& attribute,
                                  const ComparedElement& subject) {
  const std::span<const compiled::ArrayField> fields = compiled::ArrayFields(kind);
  const auto field = std::ranges::find(fields, attribute.name, &compiled::ArrayField::attribute);
  if (field == fields.end() || field->variable != nullptr) return;
  const double relative = field->IsFloat() ? kFloatRelative : kRelative;
  const auto stored = compiled::NumbersOf(m_, *field, id);
  for (std::size_t i = 0; i < std::min(stored.size(), attribute.numbers.size()); ++i) {
    const double meant = attribute.numbers[i];
    Number(subject, field->attribute, field->count == 1 ? -1 : static_cast<int>(i), stored[i],
           meant, relative * std::abs(meant));
  }
}

void Comparison::CompareJoint(int id, const model::Joint& joint) {
  const ComparedElement subject{"joint", joint.name, {}, joint.mark};
  if (!SameName(m_.names + m_.name_jntadr[id], subject, findings_)) return;
  const auto type = std::ranges::find(compiled::kJointTypes, joint.type);
  Number(subject, "type", -1, m_.jnt_type[id],
         static_cast<double>(type - compiled::kJointTypes.begin()), 0);
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
  // Skips joints with `springdamper`, from which MuJoCo computes stiffness and damping in place of
  // those in the spec.
  if (std::ranges::count(joint.attributes, "springdamper", &model::Attribute::name) > 0) return;
  for (const model::Attribute& attribute : joint.attributes) {
    CompareAttribute(mjOBJ_JOINT, id, attribute, subject);
  }
}

void Comparison::CompareSite(int id, const model::Site& site) {
  const ComparedElement subject{"site", site.name, {}, site.mark};
  if (!SameName(m_.names + m_.name_siteadr[id], subject, findings_)) return;
  Number(subject, "type", -1, m_.site_type[id], MujocoType(site.type), 0);
  for (int i = 0; i < model::SizeCount(site.type); ++i) {
    Number(subject, "size", i, m_.site_size[3 * id + i], site.size[i], kRelative * site.size[i]);
  }
  Vector(subject, "pos", m_.site_pos + 3 * id, site.X_BS.p, length_tolerance_);
  Quaternion(subject, m_.site_quat + 4 * id, site.X_BS.q);
}

}  // namespace mjforge::validate
