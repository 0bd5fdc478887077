// Computation of flags for special poses by MuJoCo's rules: equal frames (sameframe), and joints
// that allow a simple body (body_simple).

#include "mjforge/family/coincidences.h"

#include <cmath>
#include <cstddef>

#include "mjforge/structure/structure.h"

namespace mjforge::family {
namespace {

// MuJoCo treats components of a joint axis up to this size as zero (mjEPS).
constexpr double kAxisTolerance = 1e-14;

bool LetsBeSimple(const mjModel& m, int joint) {
  if (m.jnt_type[joint] == mjJNT_FREE) return true;
  const mjtNum* axis = m.jnt_axis + 3 * static_cast<std::ptrdiff_t>(joint);
  int components = 0;
  for (int i = 0; i < 3; ++i) components += std::abs(axis[i]) > kAxisTolerance ? 1 : 0;
  const mjtNum* pos = m.jnt_pos + 3 * static_cast<std::ptrdiff_t>(joint);
  return pos[0] == 0 && pos[1] == 0 && pos[2] == 0 &&
         (m.jnt_type[joint] == mjJNT_BALL || components == 1);
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
