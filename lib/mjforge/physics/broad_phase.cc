// Finds pairs of geoms that may touch, by axis-aligned boxes of bodies and then of geoms.
#include "mjforge/physics/broad_phase.h"

#include <algorithm>
#include <cstddef>

#include "mjforge/compiled/compiled.h"

namespace mjforge::physics {

using compiled::Index;
using compiled::MatrixAt;
using compiled::VectorAt;
using Eigen::Matrix3d;
using Eigen::Vector3d;

BroadPhase::BroadPhase(const mjModel& m) : m_(m), works_(IsCovered(m)) {
  if (!works_) return;
  ListBodies();
  for (const int one : bodies_) {
    for (const int two : bodies_) {
      if (one < two && MayCollide(one, two)) body_pairs_.emplace_back(one, two);
    }
  }
}

/// Returns true if bounding boxes find all contacts: MuJoCo accepts lists of pairs, the model has
/// no `<pair>` elements, and every geom is a bounded shape or a plane of the world.
bool BroadPhase::IsCovered(const mjModel& m) const {
  if (!engine::kTakesPairs || m.npair > 0) return false;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const bool is_bounded = compiled::GeomTypeOf(m.geom_type[geom]).has_value();
    if (!is_bounded && (m.geom_type[geom] != mjGEOM_PLANE || m.geom_bodyid[geom] != 0))
      return false;
  }
  return true;
}

void BroadPhase::ListBodies() {
  const std::size_t bodies = Index(m_.nbody);
  geoms_.resize(bodies);
  reaches_.resize(bodies);
  body_boxes_.resize(bodies);
  local_.resize(Index(m_.ngeom));
  boxes_.resize(Index(m_.ngeom));
  for (int geom = 0; geom < m_.ngeom; ++geom) {
    if (!compiled::Collides(m_, geom)) continue;
    const int body = m_.geom_bodyid[geom];
    geoms_[Index(body)].push_back(geom);
    double& reach = reaches_[Index(body)];
    reach = std::max(reach, VectorAt(m_.geom_pos, geom).norm() + m_.geom_rbound[geom]);
    local_[Index(geom)] = compiled::GeomBox(m_, geom, {}).ToEigen();
  }
  for (int body = 0; body < m_.nbody; ++body) {
    if (!geoms_[Index(body)].empty()) bodies_.push_back(body);
  }
}

/// Returns false for bodies that MuJoCo does not let collide: those welded to each other, a parent
/// and its child (unless the model turns `filterparent` off, or the parent is the world), and the
/// bodies of an <exclude> element.
bool BroadPhase::MayCollide(int body1, int body2) const {
  const int weld1 = m_.body_weldid[body1];
  const int weld2 = m_.body_weldid[body2];
  if (weld1 == weld2) return false;
  const bool filters = (m_.opt.disableflags & mjDSBL_FILTERPARENT) == 0 && weld1 != 0 && weld2 != 0;
  if (filters && (weld1 == m_.body_weldid[m_.body_parentid[weld2]] ||
                  weld2 == m_.body_weldid[m_.body_parentid[weld1]]))
    return false;
  for (int exclude = 0; exclude < m_.nexclude; ++exclude) {
    if (engine::ExcludedBodies(m_, exclude) == std::pair(body1, body2)) return false;
  }
  return true;
}

engine::GeomPairs& BroadPhase::Find(const mjData& d, const std::vector<double>& allowances,
                                    int frame) {
  const Matrix3d R_FW = MatrixAt(d.xmat, frame).transpose();
  const Vector3d p_WF = VectorAt(d.xpos, frame);
  for (const int body : bodies_) {
    Box& around = body_boxes_[Index(body)];
    around.setEmpty();
    for (const int geom : geoms_[Index(body)]) {
      const Box& local = local_[Index(geom)];
      Box& box = boxes_[Index(geom)];
      box = Box(Vector3d::Constant(-1e10), Vector3d::Constant(1e10));
      if (m_.geom_type[geom] != mjGEOM_PLANE) {
        const Matrix3d R_FG = R_FW * MatrixAt(d.geom_xmat, geom);
        const Vector3d center = R_FW * (VectorAt(d.geom_xpos, geom) - p_WF) + R_FG * local.center();
        const Vector3d half = R_FG.cwiseAbs() * (local.sizes() / 2) +
                              Vector3d::Constant(allowances[Index(body)] + m_.geom_margin[geom]);
        box = Box(center - half, center + half);
      }
      around.extend(box);
    }
  }
  pairs_.Clear();
  for (const auto& [body1, body2] : body_pairs_) FindBetween(body1, body2);
  return pairs_;
}

void BroadPhase::Collide(mjModel& m, mjData& d) {
  if (!works_) return mj_collision(&m, &d);
  Find(d, std::vector<double>(Index(m.nbody)), 0).Collide(m, d);
}

void BroadPhase::FindBetween(int body1, int body2) {
  const Box& around = body_boxes_[Index(body2)];
  if (!body_boxes_[Index(body1)].intersects(around)) return;
  for (const int one : geoms_[Index(body1)]) {
    const Box& box = boxes_[Index(one)];
    if (!box.intersects(around)) continue;
    for (const int two : geoms_[Index(body2)]) {
      const bool match = (m_.geom_contype[one] & m_.geom_conaffinity[two]) != 0 ||
                         (m_.geom_contype[two] & m_.geom_conaffinity[one]) != 0;
      if (match && box.intersects(boxes_[Index(two)])) pairs_.Add(m_, one, two);
    }
  }
}

}  // namespace mjforge::physics
