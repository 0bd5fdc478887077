// Detects collisions of bodies with their parents over the range of each joint.
#include "mjforge/physics/model_checks.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/joint_paths.h"
#include "mjforge/physics/stepper.h"

namespace mjforge::physics {
namespace {

// Distance that a body moves from one tried position of a joint to the next, small enough that a
// lid does not jump over a rim. On long paths the distance is larger.
constexpr double kSpacing = 0.002;  // m
constexpr int kFewestPositions = 8;
constexpr int kMostPositions = 40;

/// Copy of a model in which bodies collide with their parents.
class UnfilteredModel {
 public:
  UnfilteredModel(const mjModel& m, Workspace& workspace)
      : m_(CopyOf(m)), workspace_(workspace), data_(&workspace.For(*m_)), broad_phase_(*m_) {}

  void Put(std::span<const mjtNum> qpos) { std::ranges::copy(qpos, data_->qpos); }

  /// Returns the number of positions to try in the range of the joint that moves `body`. `range` is
  /// the length of the range, rad or m.
  int Positions(int joint, int body, double range) const {
    double way = range;
    if (m_->jnt_type[joint] != mjJNT_SLIDE) way *= Reach(joint, body);
    return std::clamp(static_cast<int>(std::ceil(way / kSpacing)), kFewestPositions,
                      kMostPositions);
  }

  /// Moves the joint of a path to `position`, which is relative to qpos0.
  void Move(const JointPath& path, double position) {
    const int at = m_->jnt_qposadr[path.joint];
    if (m_->jnt_type[path.joint] == mjJNT_BALL) {
      std::ranges::copy(
          compiled::BallAt(*m_, path.joint, Eigen::Vector3d::Unit(path.axis), position),
          data_->qpos + at);
    } else {
      data_->qpos[at] = m_->qpos0[at] + position;
    }
  }

  /// Returns the depth, m, to which a body penetrates its parent. Each of the two includes the
  /// bodies that are welded to it.
  double Depth(int body, int parent) {
    for (;;) {
      compiled::UpdatePoses(*m_, *data_);
      broad_phase_.Collide(*m_, *data_);
      if (!IsCrowded(*data_)) break;
      const std::vector<mjtNum> qpos(data_->qpos, data_->qpos + m_->nq);
      MakeRoom(*m_);
      data_ = &workspace_.For(*m_);
      Put(qpos);
    }
    double deepest = 0;
    for (const mjContact& contact : ContactsOf(*data_)) {
      const auto [low, high] = std::minmax(m_->body_weldid[m_->geom_bodyid[contact.geom1]],
                                           m_->body_weldid[m_->geom_bodyid[contact.geom2]]);
      if (low == parent && high == body) deepest = std::max(deepest, -contact.dist);
    }
    return deepest;
  }

 private:
  /// Returns the radius, m, of a sphere about the anchor of a joint that contains a body and all
  /// bodies welded to it.
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

  engine::Model m_;
  Workspace& workspace_;
  mjData* data_;
  BroadPhase broad_phase_;
};

/// Deepest penetration of a body into its parent, at the start or over the range of a joint.
/// Nothing stops the joint, because MuJoCo ignores contacts between parent and child.
struct ParentPenetration {
  int joint = 0;
  int body = 0;
  int parent = 0;
  bool is_added = false;  // true: `depth` is the increase since the start
  double depth = 0;       // m
  double where = 0;       // position of the joint, rad or m, if is_added
};

class ParentPenetrationSearch {
 public:
  explicit ParentPenetrationSearch(const ModelTest& test)
      : m_(test.m),
        checks_(test.checks()),
        entries_(m_, test.object.name, checks_),
        unfiltered_(m_, test.workspace) {}

  std::vector<ParentPenetration> Find() {
    for (const int joint : entries_.Others()) Try(joint, compiled::StartOf(m_), nullptr);
    for (const model::JointCheck& check : checks_.joints) {
      if (!check.skip.empty()) continue;
      const std::vector<mjtNum> start = entries_.StartOf(check);
      for (const int joint : entries_.JointsOf(check)) Try(joint, start, &check);
    }
    return std::move(found_);
  }

 private:
  /// Stores the penetration at the start, if it is too deep, and the increase of the penetration
  /// that the joint causes, if it is too large.
  void Try(int joint, std::span<const mjtNum> start, const model::JointCheck* check) {
    const int body = m_.body_weldid[m_.jnt_bodyid[joint]];
    const int parent = m_.body_weldid[m_.body_parentid[body]];
    const std::vector<JointPath> paths = PathsOf(m_, joint, start);
    // Skips joints whose parent body is fixed to the world, because MuJoCo does not ignore contacts
    // with such parents.
    if (parent == 0 || paths.empty()) return;
    unfiltered_.Put(start);
    ParentPenetration at_start{.joint = joint, .body = body, .parent = parent};
    at_start.depth = unfiltered_.Depth(body, parent);
    ParentPenetration added = at_start;
    added.is_added = true;
    added.depth = 0;
    for (const JointPath& path : paths) TryPositions(path, at_start.depth, added);
    const double most = check != nullptr ? check->penetration.value_or(checks_.joint_penetration)
                                         : checks_.joint_penetration;
    for (const ParentPenetration& penetration : {at_start, added})
      if (penetration.depth > most) found_.push_back(penetration);
  }

  /// Tries the positions of a path. Stores in `deepest` the largest increase of the depth over
  /// `usual`, the depth at the start.
  void TryPositions(const JointPath& path, double usual, ParentPenetration& deepest) {
    const int positions = unfiltered_.Positions(path.joint, deepest.body, path.range());
    for (int i = 0; i < positions; ++i) {
      const double at = path.low + path.range() * i / (positions - 1);
      unfiltered_.Move(path, at);
      const double depth = unfiltered_.Depth(deepest.body, deepest.parent) - usual;
      if (depth <= deepest.depth) continue;
      deepest.depth = depth;
      deepest.where =
          compiled::HasOneNumber(m_, path.joint) ? m_.qpos0[m_.jnt_qposadr[path.joint]] + at : at;
    }
  }

  const mjModel& m_;
  const model::Checks& checks_;
  JointChecks entries_;
  UnfilteredModel unfiltered_;
  std::vector<ParentPenetration> found_;
};

void ReportParent(const ModelTest& test, const ParentPenetration& penetration) {
  const std::string name = test.JointName(penetration.joint);
  if (!penetration.is_added) {
    test.reporter.Warning(
        diag::Code::kPhysicsJointPasses, test.JointMark(name),
        fmt::format("body '{}' is {} mm in its parent '{}' where joint '{}' starts; MuJoCo does "
                    "not let the two collide",
                    test.BodyName(penetration.body), expr::RoundedText(1000 * penetration.depth),
                    test.BodyName(penetration.parent), name),
        "make room; if it may be so, say how deep in an entry of `checks.joints`");
    return;
  }
  test.reporter.Warning(
      diag::Code::kPhysicsJointPasses, test.JointMark(name),
      fmt::format("joint '{}' moves body '{}' {} mm into its parent '{}', at {}; MuJoCo does "
                  "not let the two collide",
                  name, test.BodyName(penetration.body),
                  expr::RoundedText(1000 * penetration.depth), test.BodyName(penetration.parent),
                  test.Distance(penetration.joint, penetration.where)),
      "look at the axis, its sign, and the range; if it may be so, say why in `silence`");
}

}  // namespace

void CheckParents(const ModelTest& test) {
  if (!test.checks().drive) return;
  for (const ParentPenetration& penetration : ParentPenetrationSearch(test).Find())
    ReportParent(test, penetration);
}

}  // namespace mjforge::physics
