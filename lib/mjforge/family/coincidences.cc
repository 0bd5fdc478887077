// Computation of flags for special poses by MuJoCo's rules: equal frames (sameframe), and joints
// that allow a simple body (body_simple).

#include "mjforge/family/coincidences.h"

#include <cstddef>

#include "mjforge/compiled/compiled.h"
#include "mjforge/structure/structure.h"

namespace mjforge::family {
namespace {

// MuJoCo treats components of a joint axis up to this size as zero (mjEPS).
constexpr double kAxisTolerance = 1e-14;

bool LetsBeSimple(const mjModel& m, int joint) {
  if (m.jnt_type[joint] == mjJNT_FREE) return true;
  const Eigen::Array3d axis = compiled::VectorAt(m.jnt_axis, joint);
  return compiled::VectorAt(m.jnt_pos, joint) == Eigen::Vector3d::Zero() &&
         (m.jnt_type[joint] == mjJNT_BALL || (axis.abs() > kAxisTolerance).count() == 1);
}

template <typename Flag>
void AddFlags(std::string_view name, const mjModel& m, mjtObj kind, const Flag& flag,
              Numbers& numbers) {
  ArrayShape& shape = numbers.shapes.emplace_back();
  shape.name = name;
  shape.type = ArrayShape::Type::kFlag;
  const int count = ElementCount(m, kind);
  for (int id = kind == mjOBJ_BODY ? 1 : 0; id < count; ++id) {
    shape.elements.push_back(ElementName(m, kind, id));
    numbers.values.push_back(static_cast<double>(flag(id)));
  }
  shape.dims = {shape.elements.size()};
}

}  // namespace

void AddCoincidences(const mjModel& m, Numbers& numbers) {
  const auto in_body = [&](const mjtNum* pos, const mjtNum* quat, int id, int body) {
    return structure::SameFrameOf(m, body, pos + 3 * static_cast<std::ptrdiff_t>(id),
                                  quat + 4 * static_cast<std::ptrdiff_t>(id));
  };
  AddFlags(
      kBodyFlags, m, mjOBJ_BODY, [&](int id) { return structure::SameFrameOfBody(m, id); },
      numbers);
  AddFlags(
      kGeomFlags, m, mjOBJ_GEOM,
      [&](int id) { return in_body(m.geom_pos, m.geom_quat, id, m.geom_bodyid[id]); }, numbers);
  AddFlags(
      kSiteFlags, m, mjOBJ_SITE,
      [&](int id) { return in_body(m.site_pos, m.site_quat, id, m.site_bodyid[id]); }, numbers);
  AddFlags(
      kJointFlags, m, mjOBJ_JOINT, [&](int id) { return LetsBeSimple(m, id); }, numbers);
}

}  // namespace mjforge::family
