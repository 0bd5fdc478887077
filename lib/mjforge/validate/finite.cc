#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "mjforge/validate/describe.h"

namespace mjforge::validate {
namespace {

struct Checked {
  std::string_view kind;
  std::string_view what;
  std::span<const mjtNum> numbers;
  int per_element;
  const int* names;
};

template <typename Number>
std::span<const Number> Numbers(const Number* first, int count) {
  return {first, static_cast<std::size_t>(count)};
}

void Check(const mjModel& m, const Checked& checked, diag::SourceMark mark,
           diag::Findings& findings) {
  for (std::size_t i = 0; i < checked.numbers.size(); ++i) {
    if (std::isfinite(checked.numbers[i])) continue;
    const std::size_t element = i / static_cast<std::size_t>(checked.per_element);
    findings.Add(diag::Code::kMujocoWarning, mark,
                 fmt::format("MuJoCo loaded a {} of {} '{}' that is not a finite number",
                             checked.what, checked.kind, m.names + checked.names[element]));
    return;  // one of a kind is enough
  }
}

}  // namespace

void CheckFinite(const mjModel& m, diag::SourceMark mark, diag::Findings& findings) {
  const Checked all[] = {
      {"body", "mass", Numbers(m.body_mass, m.nbody), 1, m.name_bodyadr},
      {"body", "inertia", Numbers(m.body_inertia, 3 * m.nbody), 3, m.name_bodyadr},
      {"body", "pos", Numbers(m.body_pos, 3 * m.nbody), 3, m.name_bodyadr},
      {"body", "quat", Numbers(m.body_quat, 4 * m.nbody), 4, m.name_bodyadr},
      {"geom", "size", Numbers(m.geom_size, 3 * m.ngeom), 3, m.name_geomadr},
      {"geom", "pos", Numbers(m.geom_pos, 3 * m.ngeom), 3, m.name_geomadr},
      {"geom", "quat", Numbers(m.geom_quat, 4 * m.ngeom), 4, m.name_geomadr},
      {"geom", "friction", Numbers(m.geom_friction, 3 * m.ngeom), 3, m.name_geomadr},
      {"joint", "pos", Numbers(m.jnt_pos, 3 * m.njnt), 3, m.name_jntadr},
      {"joint", "axis", Numbers(m.jnt_axis, 3 * m.njnt), 3, m.name_jntadr},
      {"joint", "range", Numbers(m.jnt_range, 2 * m.njnt), 2, m.name_jntadr},
      {"site", "pos", Numbers(m.site_pos, 3 * m.nsite), 3, m.name_siteadr},
  };
  for (const Checked& checked : all) Check(m, checked, mark, findings);
  for (int i = 0; i < m.nq; ++i) {
    if (std::isfinite(m.qpos0[i])) continue;
    findings.Add(
        diag::Code::kMujocoWarning, mark,
        fmt::format("MuJoCo loaded a start position {} that is not a finite number", i + 1));
    return;
  }
}

}  // namespace mjforge::validate
