#include "mjforge/physics/stepper.h"

#include <algorithm>
#include <cstddef>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

using compiled::VectorAt;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t Nth(int i) { return static_cast<std::size_t>(i); }

// Pairs are sought anew after about as many steps.
constexpr double kStepsBetween = 12;
constexpr double kLeastAllowance = 0.0005;  // m
constexpr double kMostAllowance = 0.05;     // m

Matrix3d MatrixAt(const mjtNum* array, int id) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(array + 9 * static_cast<std::ptrdiff_t>(id));
}

bool IsPlane(const mjModel& m, int geom) { return m.geom_type[geom] == mjGEOM_PLANE; }

}  // namespace

NearPairs::NearPairs(const mjModel& m) : m_(m), works_(IsCovered(m)) {
  if (!works_) return;
  ListBodies();
  for (const int one : bodies_) {
    for (const int two : bodies_) {
      if (one < two && MayCollide(one, two)) body_pairs_.emplace_back(one, two);
    }
  }
}

/// Whether MuJoCo does nothing else: no pairs of the file's own, and nothing without bounds but
/// planes of the world.
bool NearPairs::IsCovered(const mjModel& m) const {
  if (!engine::kTakesPairs || m.npair > 0) return false;
  for (int geom = 0; geom < m.ngeom; ++geom) {
    const bool is_bounded = compiled::GeomTypeOf(m.geom_type[geom]).has_value();
    if (!is_bounded && !(IsPlane(m, geom) && m.geom_bodyid[geom] == 0)) return false;
  }
  return true;
}

void NearPairs::ListBodies() {
  const std::size_t bodies = Nth(m_.nbody);
  geoms_.resize(bodies);
  reaches_.resize(bodies);
  body_boxes_.resize(bodies);
  local_.resize(Nth(m_.ngeom));
  boxes_.resize(Nth(m_.ngeom));
  for (int geom = 0; geom < m_.ngeom; ++geom) {
    if (!compiled::Collides(m_, geom)) continue;
    const int body = m_.geom_bodyid[geom];
    geoms_[Nth(body)].push_back(geom);
    double& reach = reaches_[Nth(body)];
    reach = std::max(reach, VectorAt(m_.geom_pos, geom).norm() + m_.geom_rbound[geom]);
    const model::Box3 box = compiled::GeomBox(m_, geom, {});
    if (!box.empty()) local_[Nth(geom)] = Box(box.min, box.max);
  }
  for (int body = 0; body < m_.nbody; ++body) {
    if (!geoms_[Nth(body)].empty()) bodies_.push_back(body);
  }
}

/// As mj_contactFilter and <exclude> have it.
bool NearPairs::MayCollide(int body1, int body2) const {
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

engine::GeomPairs& NearPairs::Find(const mjData& d, const std::vector<double>& allowances,
                                   int frame) {
  const Matrix3d R_FW = MatrixAt(d.xmat, frame).transpose();
  const Vector3d p_WF = VectorAt(d.xpos, frame);
  for (const int body : bodies_) {
    Box& around = body_boxes_[Nth(body)];
    around.setEmpty();
    for (const int geom : geoms_[Nth(body)]) {
      const Box& local = local_[Nth(geom)];
      Box& box = boxes_[Nth(geom)];
      box = Box(Vector3d::Constant(-1e10), Vector3d::Constant(1e10));
      if (!IsPlane(m_, geom)) {
        const Matrix3d R_FG = R_FW * MatrixAt(d.geom_xmat, geom);
        const Vector3d center = R_FW * (VectorAt(d.geom_xpos, geom) - p_WF) + R_FG * local.center();
        const Vector3d half = R_FG.cwiseAbs() * (local.sizes() / 2) +
                              Vector3d::Constant(allowances[Nth(body)] + m_.geom_margin[geom]);
        box = Box(center - half, center + half);
      }
      around.extend(box);
    }
  }
  pairs_.Clear();
  for (const auto& [body1, body2] : body_pairs_) FindBetween(body1, body2);
  return pairs_;
}

void NearPairs::FindBetween(int body1, int body2) {
  const Box& around = body_boxes_[Nth(body2)];
  if (!body_boxes_[Nth(body1)].intersects(around)) return;
  for (const int one : geoms_[Nth(body1)]) {
    const Box& box = boxes_[Nth(one)];
    if (!box.intersects(around)) continue;
    for (const int two : geoms_[Nth(body2)]) {
      const bool match = (m_.geom_contype[one] & m_.geom_conaffinity[two]) != 0 ||
                         (m_.geom_contype[two] & m_.geom_conaffinity[one]) != 0;
      if (match && box.intersects(boxes_[Nth(two)])) pairs_.Add(m_, one, two);
    }
  }
}

Stepper::Stepper(mjModel& m, mjData& d)
    : m_(m),
      d_(d),
      near_(m),
      frame_(FrameOf()),
      places_(Nth(m.nbody)),
      allowances_(Nth(m.nbody), 2 * kLeastAllowance),
      moved_(Nth(m.nbody)) {}

/// If all that moves is on one body, that body: falling, its parts stay near each other. A plane
/// is near everything anyway.
int Stepper::FrameOf() const {
  int root = -1;
  for (int dof = 0; dof < m_.nv; ++dof) {
    const int other = m_.body_rootid[m_.dof_bodyid[dof]];
    if (root >= 0 && other != root) return 0;
    root = other;
  }
  for (const int body : near_.bodies()) {
    if (m_.body_rootid[body] != root && body != 0) return 0;
  }
  for (int geom = 0; geom < m_.ngeom; ++geom) {
    if (m_.geom_bodyid[geom] == 0 && compiled::Collides(m_, geom) && !IsPlane(m_, geom)) return 0;
  }
  return std::max(root, 0);
}

void Stepper::Step() {
  // Runge and Kutta look at more poses than one.
  if (!near_.works() || m_.opt.integrator == mjINT_RK4) {
    mj_step(&m_, &d_);
    return;
  }
  Save();
  if (is_stale_) Find();
  pairs_->Step(m_, d_);
  if (Look() || HasBlownUp(d_)) return;
  // Something moved farther than was foreseen.
  Restore();
  Find();
  pairs_->Step(m_, d_);
}

Stepper::Place Stepper::PlaceOf(int body) const {
  const Matrix3d R_FW = MatrixAt(d_.xmat, frame_).transpose();
  return {R_FW * (VectorAt(d_.xpos, body) - VectorAt(d_.xpos, frame_)),
          R_FW * MatrixAt(d_.xmat, body)};
}

void Stepper::Find() {
  mj_kinematics(&m_, &d_);
  Restore();  // quaternions are made unit ones there, which changes their last bits
  for (const int body : near_.bodies()) {
    const auto i = Nth(body);
    places_[i] = PlaceOf(body);
    if (steps_ > 0)
      allowances_[i] =
          std::clamp(kStepsBetween * moved_[i] / steps_, kLeastAllowance, kMostAllowance);
  }
  pairs_ = &near_.Find(d_, allowances_, frame_);
  steps_ = 0;
  is_stale_ = false;
}

/// Whether the last step, which left bodies where they were before it, had all pairs.
bool Stepper::Look() {
  ++steps_;
  bool had_all = true;
  for (const int body : near_.bodies()) {
    if (body == 0) continue;  // if the frame moves, it has planes alone
    const auto i = Nth(body);
    const Place place = PlaceOf(body);
    moved_[i] =
        (place.p - places_[i].p).norm() + (place.R - places_[i].R).norm() * near_.Reach(body);
    had_all = had_all && moved_[i] <= allowances_[i];
    // Two steps on, at the same pace.
    is_stale_ = is_stale_ || moved_[i] * (1 + 2.0 / steps_) > allowances_[i];
  }
  return had_all;
}

void Stepper::Save() {
  state_.time = d_.time;
  state_.qpos.assign(d_.qpos, d_.qpos + m_.nq);
  state_.qvel.assign(d_.qvel, d_.qvel + m_.nv);
  state_.act.assign(d_.act, d_.act + m_.na);
  state_.warmstart.assign(d_.qacc_warmstart, d_.qacc_warmstart + m_.nv);
  state_.mocap_quat.assign(d_.mocap_quat, d_.mocap_quat + 4 * m_.nmocap);
}

void Stepper::Restore() {
  d_.time = state_.time;
  std::ranges::copy(state_.qpos, d_.qpos);
  std::ranges::copy(state_.qvel, d_.qvel);
  std::ranges::copy(state_.act, d_.act);
  std::ranges::copy(state_.warmstart, d_.qacc_warmstart);
  std::ranges::copy(state_.mocap_quat, d_.mocap_quat);
}

}  // namespace mjforge::physics
