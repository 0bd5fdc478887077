#include "mjforge/physics/adrift.h"

#include <algorithm>
#include <limits>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {
namespace {

constexpr double kFarOff = 0.25;  // of the body's size

bool HangsOnJoint(const mjModel& m, int body) {
  for (int i = 0; i < m.body_jntnum[body]; ++i) {
    if (compiled::HasOneNumber(m, m.body_jntadr[body] + i)) return m.body_parentid[body] != 0;
  }
  return false;
}

}  // namespace

std::vector<Adrift> AdriftBodies(const mjModel& m, mjData& d) {
  std::ranges::copy(compiled::StartOf(m), d.qpos);
  mj_kinematics(&m, &d);
  std::vector<Eigen::AlignedBox3d> boxes(static_cast<std::size_t>(m.ngeom));
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const model::Box3 box = compiled::GeomBox(m, geom, compiled::GeomPose(d, geom));
    if (!box.empty()) boxes[static_cast<std::size_t>(geom)] = {box.min, box.max};
  }
  std::vector<Adrift> adrift;
  for (int body = 1; body < m.nbody; ++body) {
    if (!HangsOnJoint(m, body)) continue;
    Eigen::AlignedBox3d own;
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (m.body_weldid[m.geom_bodyid[geom]] == m.body_weldid[body])
        own.extend(boxes[static_cast<std::size_t>(geom)]);
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (int geom = 0; geom < m.ngeom; ++geom) {
      const int other = m.geom_bodyid[geom];
      const bool is_other = m.body_weldid[other] != m.body_weldid[body] &&
                            m.body_rootid[other] == m.body_rootid[body];
      const auto& box = boxes[static_cast<std::size_t>(geom)];
      if (is_other && !box.isEmpty()) nearest = std::min(nearest, own.exteriorDistance(box));
    }
    const bool has_both = !own.isEmpty() && nearest < std::numeric_limits<double>::infinity();
    if (has_both && nearest > kFarOff * own.diagonal().norm()) adrift.push_back({body, nearest});
  }
  return adrift;
}

}  // namespace mjforge::physics
