#include "mjforge/physics/passing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

// How far a body moves from one position to the next, so that a lid does not jump over a rim; where
// the way is long, farther.
constexpr double kApart = 0.002;  // m
constexpr int kFewest = 8;
constexpr int kMost = 40;

/// The model, in which parents collide with their children.
class Unfiltered {
 public:
  Unfiltered(const mjModel& m, Workspace& workspace)
      : m_(CopyOf(m)), workspace_(workspace), data_(&workspace.For(*m_)), near_(*m_) {}

  void Put(std::span<const mjtNum> qpos) { std::ranges::copy(qpos, data_->qpos); }

  /// Into how many positions a range of a joint is divided that moves a body.
  int Positions(int joint, int body, double range) const {
    double way = range;
    if (m_->jnt_type[joint] == mjJNT_HINGE) way *= Reach(joint, body);
    return std::clamp(static_cast<int>(std::ceil(way / kApart)), kFewest, kMost);
  }

  void Move(int joint, double position) { data_->qpos[m_->jnt_qposadr[joint]] = position; }

  /// How deep a body, with all that is welded to it, is in its parent, m.
  double Depth(int body, int parent) {
    for (;;) {
      mj_kinematics(m_.get(), data_);
      mj_comPos(m_.get(), data_);
      Collide();
      if (data_->warning[mjWARN_CONTACTFULL].number == 0) break;
      const std::vector<mjtNum> qpos(data_->qpos, data_->qpos + m_->nq);
      if (!MakeRoom(*m_, *data_)) break;
      data_ = &workspace_.For(*m_);
      Put(qpos);
    }
    double deepest = 0;
    for (int i = 0; i < data_->ncon; ++i) {
      const mjContact& contact = data_->contact[i];
      const auto [low, high] = std::minmax(m_->body_weldid[m_->geom_bodyid[contact.geom1]],
                                           m_->body_weldid[m_->geom_bodyid[contact.geom2]]);
      if (low == parent && high == body) deepest = std::max(deepest, -contact.dist);
    }
    return deepest;
  }

 private:
  /// How far a body, with all that is welded to it, reaches from a joint's anchor, m.
  double Reach(int joint, int body) const {
    double reach = 0;
    for (int geom = 0; geom < m_->ngeom; ++geom) {
      if (m_->body_weldid[m_->geom_bodyid[geom]] != body) continue;
      const Eigen::Vector3d arm =
          compiled::VectorAt(data_->geom_xpos, geom) - compiled::VectorAt(data_->xanchor, joint);
      reach = std::max(reach, arm.norm() + m_->geom_rbound[geom]);
    }
    return reach;
  }

  static engine::Model CopyOf(const mjModel& m) {
    engine::Model copy(mj_copyModel(nullptr, &m));
    copy->opt.disableflags |= mjDSBL_FILTERPARENT;
    return copy;
  }

  void Collide() {
    if (near_.works()) {
      near_.Find(*data_, exactly_, 0).Collide(*m_, *data_);
    } else {
      mj_collision(m_.get(), data_);
    }
  }

  engine::Model m_;
  Workspace& workspace_;
  mjData* data_;
  NearPairs near_;
  std::vector<double> exactly_ = std::vector<double>(static_cast<std::size_t>(m_->nbody));
};

class Passings {
 public:
  Passings(const mjModel& m, Workspace& workspace, std::string_view object,
           const model::Checks& checks)
      : m_(m), checks_(checks), entries_(m, object, checks), unfiltered_(m, workspace) {}

  std::vector<Passing> Find() {
    std::vector<Passing> found;
    const auto look = [&](int joint, std::span<const mjtNum> start,
                          const model::JointCheck* check) {
      const std::optional<Passing> passing = Look(joint, start, check);
      if (passing) found.push_back(*passing);
    };
    for (const int joint : entries_.Others()) look(joint, compiled::StartOf(m_), nullptr);
    for (const model::JointCheck& check : checks_.joints) {
      if (!check.skip.empty()) continue;
      const std::vector<mjtNum> start = entries_.StartOf(check);
      for (const int joint : entries_.JointsOf(check)) look(joint, start, &check);
    }
    return found;
  }

 private:
  std::optional<Passing> Look(int joint, std::span<const mjtNum> start,
                              const model::JointCheck* check) {
    const int body = m_.body_weldid[m_.jnt_bodyid[joint]];
    const int parent = m_.body_weldid[m_.body_parentid[body]];
    const std::optional<compiled::JointRange> range = compiled::RangeOf(m_, joint);
    // MuJoCo does let a body collide with the world.
    if (parent == 0 || m_.jnt_type[joint] == mjJNT_BALL || !range) return std::nullopt;
    Passing deepest{.joint = joint, .body = body, .parent = parent, .check = check};
    unfiltered_.Put(start);
    const double usual = unfiltered_.Depth(body, parent);
    const int positions = unfiltered_.Positions(joint, body, range->high - range->low);
    for (int i = 0; i < positions; ++i) {
      const double at = range->low + (range->high - range->low) * i / (positions - 1);
      unfiltered_.Move(joint, at);
      const double depth = unfiltered_.Depth(body, parent) - usual;
      if (depth <= deepest.depth) continue;
      deepest.depth = depth;
      deepest.where = at;
    }
    const double most = check != nullptr ? check->penetration.value_or(checks_.joint_penetration)
                                         : checks_.joint_penetration;
    return deepest.depth > most ? std::optional(deepest) : std::nullopt;
  }

  const mjModel& m_;
  const model::Checks& checks_;
  JointChecks entries_;
  Unfiltered unfiltered_;
};

}  // namespace

std::vector<Passing> PassingJoints(const mjModel& m, Workspace& workspace, std::string_view object,
                                   const model::Checks& checks) {
  if (!checks.drive) return {};
  return Passings(m, workspace, object, checks).Find();
}

}  // namespace mjforge::physics
