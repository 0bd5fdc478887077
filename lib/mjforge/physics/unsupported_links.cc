// Check for bodies on hinges and slides that are far from all other bodies of their tree, at the
// start or at an end of a range.
#include "mjforge/physics/model_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/joint_couplings.h"
#include "mjforge/physics/joint_paths.h"

namespace mjforge::physics {
namespace {

using compiled::Index;

constexpr double kFarOff = 0.03;  // m; a body farther than this from all others hangs in the air
constexpr double kFarOffOfSize = 0.25;  // the limit as a share of the diagonal of the body's box

class UnsupportedLinks {
 public:
  explicit UnsupportedLinks(const ModelTest& test)
      : test_(test), m_(test.m), d_(test.workspace.For(test.m)), couplings_(test.m) {
    std::ranges::copy(compiled::StartOf(m_), d_.qpos);
    mj_kinematics(&m_, &d_);
    for (int geom = 0; geom < m_.ngeom; ++geom)
      boxes_.push_back(compiled::GeomBox(m_, geom, compiled::GeomPose(d_, geom)).ToEigen());
  }

  void Check() {
    for (int body = 1; body < m_.nbody; ++body)
      if (HangsOnJoint(body)) CheckStart(body);
    for (int joint = 0; joint < m_.njnt; ++joint)
      if (m_.body_parentid[m_.jnt_bodyid[joint]] != 0 && compiled::HasOneNumber(m_, joint) &&
          m_.jnt_limited[joint] != 0 && !couplings_.IsCoupled(joint))
        CheckEnds(joint);
  }

 private:
  using Box = Eigen::AlignedBox3d;

  bool HangsOnJoint(int body) const {
    for (int i = 0; i < m_.body_jntnum[body]; ++i) {
      if (compiled::HasOneNumber(m_, m_.body_jntadr[body] + i)) return m_.body_parentid[body] != 0;
    }
    return false;
  }

  void CheckStart(int body) {
    Box own;
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      if (m_.body_weldid[m_.geom_bodyid[geom]] == m_.body_weldid[body])
        own.extend(boxes_[Index(geom)]);
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      const int other = m_.geom_bodyid[geom];
      const bool is_other = m_.body_weldid[other] != m_.body_weldid[body] &&
                            m_.body_rootid[other] == m_.body_rootid[body];
      const Box& box = boxes_[Index(geom)];
      if (is_other && !box.isEmpty()) nearest = std::min(nearest, own.exteriorDistance(box));
    }
    const bool has_both = !own.isEmpty() && nearest < std::numeric_limits<double>::infinity();
    if (!has_both || nearest <= std::min(kFarOff, kFarOffOfSize * own.diagonal().norm())) return;
    is_far_at_start_.insert(m_.body_jntadr[body]);
    Report(m_.body_jntadr[body], "", nearest, "look at its `pos` and the units");
  }

  void CheckEnds(int joint) {
    const int body = m_.jnt_bodyid[joint];
    if (is_far_at_start_.contains(m_.body_jntadr[body])) return;
    const std::vector<bool> moved = BodiesMovedBy(m_, joint);
    const JointPath path = PathsOf(m_, joint, compiled::StartOf(m_)).front();
    const bool is_slide = m_.jnt_type[joint] == mjJNT_SLIDE;
    const double way = std::max(path.start - path.low, path.high - path.start);
    const bool is_too_long = path.range() > LongestSlide(test_.object, test_.checks());
    // Leaves out slides with ranges that are too long, because the check physics/joint-range
    // reports them.
    if (is_slide && (is_too_long || DistanceAfter(joint, moved, 0) + way <= kFarOff)) return;
    // Allows hinges a larger distance: the axis of a hinge may be beside the edge of its door, and
    // then the open door is away from its frame by up to the distance of the axis and the thickness
    // of the door.
    const double most =
        is_slide ? kFarOff : std::max(kFarOff, kFarOffOfSize * MovedBox(moved).diagonal().norm());
    for (const double end : {path.low, path.high}) {
      if (is_slide && Lifts(joint, end - path.start)) continue;
      const double distance = DistanceAfter(joint, moved, end - path.start);
      if (distance <= most || distance == std::numeric_limits<double>::infinity()) continue;
      const double where = end + m_.qpos0[m_.jnt_qposadr[joint]];
      Report(joint,
             fmt::format(" where joint '{}' is at {}", test_.JointName(joint),
                         test_.Distance(joint, where)),
             distance, "use a shorter range; if it may be so, say why in `silence`");
      return;
    }
  }

  Box MovedBox(const std::vector<bool>& moved) const {
    Box box;
    for (int geom = 0; geom < m_.ngeom; ++geom)
      if (moved[Index(m_.geom_bodyid[geom])]) box.extend(boxes_[Index(geom)]);
    return box;
  }

  /// Returns true if a slide moves its body up, less than 45 degrees from the vertical. A lifted
  /// body, such as a lid, need not be near other bodies, because a hand holds the lifted body.
  bool Lifts(int joint, double way) const {
    const Eigen::Map<const Eigen::Vector3d> gravity(m_.opt.gravity);
    const double up = -way * compiled::VectorAt(d_.xaxis, joint).dot(gravity);
    return up > std::sqrt(0.5) * std::abs(way) * gravity.norm();
  }

  /// Returns the distance between the bodies that a joint moves and the other bodies of their tree,
  /// m, after the joint has moved by `way` (rad or m). A result up to kFarOff is an upper bound,
  /// because the search stops at the first distance up to kFarOff.
  double DistanceAfter(int joint, const std::vector<bool>& moved, double way) const {
    const Eigen::Vector3d axis = compiled::VectorAt(d_.xaxis, joint);
    const Eigen::Vector3d anchor = compiled::VectorAt(d_.xanchor, joint);
    model::Pose motion;
    if (m_.jnt_type[joint] == mjJNT_SLIDE) {
      motion.p = way * axis;
    } else {
      motion.q = Eigen::AngleAxisd(way, axis);
      motion.p = anchor - motion.q * anchor;
    }
    const int root = m_.body_rootid[m_.jnt_bodyid[joint]];
    double nearest = std::numeric_limits<double>::infinity();
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      if (!moved[Index(m_.geom_bodyid[geom])] || boxes_[Index(geom)].isEmpty()) continue;
      const Box box = compiled::GeomBox(m_, geom, motion * compiled::GeomPose(d_, geom)).ToEigen();
      for (int other = 0; other < m_.ngeom; ++other) {
        const int body = m_.geom_bodyid[other];
        if (moved[Index(body)] || m_.body_rootid[body] != root || boxes_[Index(other)].isEmpty())
          continue;
        nearest = std::min(nearest, box.exteriorDistance(boxes_[Index(other)]));
        if (nearest <= kFarOff) return nearest;
      }
    }
    return nearest;
  }

  void Report(int joint, const std::string& where, double distance, const char* hint) {
    test_.reporter.Warning(diag::Code::kPhysicsLoose, test_.JointMark(test_.JointName(joint)),
                           fmt::format("body '{}' hangs in the air{}: {} mm from all else of '{}'",
                                       test_.BodyName(m_.jnt_bodyid[joint]), where,
                                       expr::RoundedText(1000 * distance), test_.object.name),
                           hint);
  }

  const ModelTest& test_;
  const mjModel& m_;
  mjData& d_;
  JointCouplings couplings_;
  std::vector<Box> boxes_;         // boxes of geoms at the start
  std::set<int> is_far_at_start_;  // first joints of bodies that are far off at the start
};

}  // namespace

void CheckUnsupportedLinks(const ModelTest& test) { UnsupportedLinks(test).Check(); }

}  // namespace mjforge::physics
