// Simulation steps: finds the pairs of geoms near each other for several steps ahead, and repeats a
// step if a body moved farther than expected.
#include "mjforge/physics/stepper.h"

#include <algorithm>
#include <cstddef>

#include "mjforge/compiled/compiled.h"
#include "mjforge/physics/simulation.h"

namespace mjforge::physics {
namespace {

using compiled::Index;
using compiled::MatrixAt;
using compiled::VectorAt;
using Eigen::Matrix3d;

constexpr double kStepsBetween = 12;        // approximate number of steps with one list of pairs
constexpr double kLeastAllowance = 0.0005;  // m
constexpr double kMostAllowance = 0.05;     // m

}  // namespace

Stepper::Stepper(mjModel& m, mjData& d)
    : m_(m),
      d_(d),
      broad_phase_(m),
      frame_(FrameOf()),
      poses_(Index(m.nbody)),
      allowances_(Index(m.nbody), 2 * kLeastAllowance),
      moved_(Index(m.nbody)),
      state_{{&d.time, 1},
             {d.qpos, Index(m.nq)},
             {d.qvel, Index(m.nv)},
             {d.act, Index(m.na)},
             {d.qacc_warmstart, Index(m.nv)},
             {d.mocap_quat, Index(4 * m.nmocap)}} {}

/// Returns the body relative to which motions of other bodies are measured: the root of the only
/// tree with joints, because the bodies of a falling tree stay near each other. Returns 0 (the
/// world) if several trees have joints, or if colliding geoms other than planes are outside of that
/// tree. Planes do not matter, because their boxes contain everything.
int Stepper::FrameOf() const {
  int root = -1;
  for (int dof = 0; dof < m_.nv; ++dof) {
    const int other = m_.body_rootid[m_.dof_bodyid[dof]];
    if (root >= 0 && other != root) return 0;
    root = other;
  }
  for (const int body : broad_phase_.bodies()) {
    if (m_.body_rootid[body] != root && body != 0) return 0;
  }
  for (int geom = 0; geom < m_.ngeom; ++geom) {
    if (m_.geom_bodyid[geom] == 0 && compiled::Collides(m_, geom) &&
        m_.geom_type[geom] != mjGEOM_PLANE)
      return 0;
  }
  return std::max(root, 0);
}

void Stepper::Step() {
  if (recorder_ != nullptr) recorder_->Record(m_, d_);
  // Lets MuJoCo find all pairs in a Runge-Kutta step, which detects collisions at several poses.
  if (!broad_phase_.works() || m_.opt.integrator == mjINT_RK4) {
    mj_step(&m_, &d_);
    return;
  }
  Save();
  if (is_stale_) FindPairs();
  pairs_->Step(m_, d_);
  if (HadAllPairs() || HasDiverged(d_)) return;
  // Repeats the step, because a body moved farther than its allowance.
  Restore();
  FindPairs();
  pairs_->Step(m_, d_);
}

Stepper::BodyPose Stepper::PoseOf(int body) const {
  const Matrix3d R_FW = MatrixAt(d_.xmat, frame_).transpose();
  return {R_FW * (VectorAt(d_.xpos, body) - VectorAt(d_.xpos, frame_)),
          R_FW * MatrixAt(d_.xmat, body)};
}

void Stepper::FindPairs() {
  mj_kinematics(&m_, &d_);
  Restore();  // mj_kinematics normalizes quaternions, which changes their last bits
  for (const int body : broad_phase_.bodies()) {
    const auto i = Index(body);
    poses_[i] = PoseOf(body);
    if (steps_ > 0)
      allowances_[i] =
          std::clamp(kStepsBetween * moved_[i] / steps_, kLeastAllowance, kMostAllowance);
  }
  pairs_ = &broad_phase_.Find(d_, allowances_, frame_);
  steps_ = 0;
  is_stale_ = false;
}

/// Returns true if no body had moved farther than its allowance before the last step, which
/// therefore missed no pair. mjData has the poses from before that step. Also sets is_stale_.
bool Stepper::HadAllPairs() {
  ++steps_;
  bool had_all = true;
  for (const int body : broad_phase_.bodies()) {
    if (body == 0) continue;  // the world is frame_ itself, or has only planes
    const auto i = Index(body);
    const BodyPose pose = PoseOf(body);
    moved_[i] =
        (pose.p - poses_[i].p).norm() + (pose.R - poses_[i].R).norm() * broad_phase_.Reach(body);
    had_all = had_all && moved_[i] <= allowances_[i];
    // Expected movement after two more steps at the same speed.
    is_stale_ = is_stale_ || moved_[i] * (1 + 2.0 / steps_) > allowances_[i];
  }
  return had_all;
}

void Stepper::Save() {
  before_.clear();
  for (const auto& part : state_) before_.insert(before_.end(), part.begin(), part.end());
}

void Stepper::Restore() {
  auto from = before_.cbegin();
  for (const auto& part : state_) {
    std::copy_n(from, part.size(), part.begin());
    from += std::ssize(part);
  }
}

}  // namespace mjforge::physics
