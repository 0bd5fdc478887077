// Bodies on hinges and slides with nothing else of their object near them.
#include "mjforge/physics/unsupported_links.h"

#include <algorithm>
#include <limits>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {
namespace {

constexpr double kFarOff = 0.25;  // share of the body's size

bool HangsOnJoint(const mjModel& m, int body) {
  for (int i = 0; i < m.body_jntnum[body]; ++i) {
    if (compiled::HasOneNumber(m, m.body_jntadr[body] + i)) return m.body_parentid[body] != 0;
  }
  return false;
}

}  // namespace

std::vector<UnsupportedLink> FindUnsupportedLinks(const mjModel& m, mjData& d) {
  std::ranges::copy(compiled::StartOf(m), d.qpos);
  mj_kinematics(&m, &d);
  std::vector<Eigen::AlignedBox3d> boxes(compiled::Index(m.ngeom));
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const model::Box3 box = compiled::GeomBox(m, geom, compiled::GeomPose(d, geom));
    if (!box.empty()) boxes[compiled::Index(geom)] = {box.min, box.max};
  }
  std::vector<UnsupportedLink> unsupported;
  for (int body = 1; body < m.nbody; ++body) {
    if (!HangsOnJoint(m, body)) continue;
    Eigen::AlignedBox3d own;
    for (int geom = 0; geom < m.ngeom; ++geom) {
      if (m.body_weldid[m.geom_bodyid[geom]] == m.body_weldid[body])
        own.extend(boxes[compiled::Index(geom)]);
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (int geom = 0; geom < m.ngeom; ++geom) {
      const int other = m.geom_bodyid[geom];
      const bool is_other = m.body_weldid[other] != m.body_weldid[body] &&
                            m.body_rootid[other] == m.body_rootid[body];
      const auto& box = boxes[compiled::Index(geom)];
      if (is_other && !box.isEmpty()) nearest = std::min(nearest, own.exteriorDistance(box));
    }
    const bool has_both = !own.isEmpty() && nearest < std::numeric_limits<double>::infinity();
    if (has_both && nearest > kFarOff * own.diagonal().norm())
      unsupported.push_back({body, nearest});
  }
  return unsupported;
}

}  // namespace mjforge::physics
