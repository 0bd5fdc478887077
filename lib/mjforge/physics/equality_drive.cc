// Drives the joints that equality constraints couple, and finds the largest error of each
// constraint.
#include "mjforge/physics/equality_drive.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/physics/held_model.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/joint_controller.h"
#include "mjforge/physics/joint_paths.h"

namespace mjforge::physics {
namespace {

using compiled::Index;
using compiled::Moves;

/// Equality constraints of a model, and the joints that they couple.
class Equalities {
 public:
  explicit Equalities(const mjModel& m) : m_(m) {}

  /// Returns true for an active equality of two joints.
  bool IsOfJoints(int equality) const {
    return IsActive(equality) && m_.eq_type[equality] == mjEQ_JOINT && m_.eq_obj2id[equality] >= 0;
  }

  /// Returns true if the equality is active and couples the joint. Then driving the joint tests the
  /// equality (see DriveEqualities).
  bool IsTestedBy(int equality, int joint) const {
    if (!IsActive(equality) || !compiled::HasOneNumber(m_, joint)) return false;
    const int first = m_.eq_obj1id[equality];
    const int second = m_.eq_obj2id[equality];
    switch (m_.eq_type[equality]) {
      case mjEQ_JOINT:
        return second >= 0 && (joint == second || (joint == first && IsLinear(equality)));
      case mjEQ_TENDON:
        return IsLimited(joint) && (IsOnTendon(m_, joint, first) || IsOnTendon(m_, joint, second));
      case mjEQ_CONNECT:
      case mjEQ_WELD: {
        const auto [body1, body2] = engine::BodiesOfEquality(m_, equality);
        return IsLimited(joint) && (Moves(m_, joint, body1) || Moves(m_, joint, body2));
      }
      default:
        return false;
    }
  }

  /// Returns the distance that counts as an error of 100 %, m or rad: for an equality of two
  /// joints, the travel of joint 1 while joint 2 moves from end to end; for other equalities, the
  /// size of the model.
  double ScaleOf(int equality) const {
    if (!IsOfJoints(equality)) return m_.stat.extent;
    const auto [low, high] = PositionsOf(equality);
    return high - low;
  }

  /// Sets the members `outside...` of `drive`: the joint that the equality would move out of its
  /// range.
  void FindOutside(EqualityDrive& drive) const {
    if (!IsOfJoints(drive.equality)) return;
    const JointEquality joints = JointEqualityAt(m_, drive.equality);
    const auto note = [&](int joint, const std::pair<double, double>& asked, double slope) {
      if (!IsLimited(joint)) return;
      const double zero = m_.qpos0[m_.jnt_qposadr[joint]];
      const double outside = std::max(m_.jnt_range[2 * joint] - zero - asked.first,
                                      asked.second - (m_.jnt_range[2 * joint + 1] - zero));
      if (outside * slope <= drive.outside_error) return;
      drive.outside_joint = joint;
      drive.outside = outside;
      drive.outside_error = outside * slope;
    };
    note(joints.y, PositionsOf(drive.equality), 1);
    const std::vector<JointPath> own = PathsOf(m_, joints.y, compiled::StartOf(m_));
    const double slope = joints.poly[1];
    if (own.empty() || !IsLinear(drive.equality)) return;
    note(joints.x,
         std::minmax(
             {(own[0].low - joints.poly[0]) / slope, (own[0].high - joints.poly[0]) / slope}),
         std::abs(slope));
  }

  /// Returns true if MuJoCo makes the equality more than twice as soft as it would be with the
  /// joints exchanged, because the inverse inertia that scales the softness ignores the slope.
  /// Source: mj_diagApprox of MuJoCo 2.2 (src/engine/engine_core_constraint.c).
  bool IsReversed(int equality) const {
    if (!IsOfJoints(equality) || !IsLinear(equality)) return false;
    const double slope = m_.eq_data[mjNEQDATA * equality + 1];
    const double first = InverseInertiaOf(m_.eq_obj1id[equality]);
    const double second = InverseInertiaOf(m_.eq_obj2id[equality]);
    return first + second > 2 * (first + slope * slope * second);
  }

 private:
  bool IsActive(int equality) const { return (m_.*engine::kEqualityActive)[equality] != 0; }
  bool IsLimited(int joint) const { return m_.jnt_limited[joint] != 0; }
  bool IsLinear(int equality) const { return JointEqualityAt(m_, equality).IsLinear(); }

  double InverseInertiaOf(int joint) const { return m_.dof_invweight0[m_.jnt_dofadr[joint]]; }

  /// Returns the lowest and the highest position of joint 1, relative to qpos0, while joint 2 moves
  /// from end to end. If joint 2 has no path, returns the ends of joint 1's own path.
  std::pair<double, double> PositionsOf(int equality) const {
    constexpr int kSteps = 50;
    const int second = m_.eq_obj2id[equality];
    const std::vector<JointPath> paths = PathsOf(m_, second, compiled::StartOf(m_));
    if (paths.empty()) {
      const std::vector<JointPath> own = PathsOf(m_, m_.eq_obj1id[equality], compiled::StartOf(m_));
      return own.empty() ? std::pair(0.0, 0.0) : std::pair(own[0].low, own[0].high);
    }
    const JointEquality joints = JointEqualityAt(m_, equality);
    std::pair<double, double> ends = {mjMAXVAL, -mjMAXVAL};
    for (int i = 0; i <= kSteps; ++i) {
      const double x = paths[0].low + paths[0].range() * i / kSteps;
      const double y = joints.At(x);
      ends = {std::min(ends.first, y), std::max(ends.second, y)};
    }
    return ends;
  }

  const mjModel& m_;
};

/// Returns the joints whose drives test an equality (IsTestedBy), in order of id, except joints
/// with `skip` in checks.joints.
std::vector<int> TestingJoints(const mjModel& m, const Equalities& equalities,
                               std::string_view object, const model::Checks& checks) {
  const JointChecks entries(m, object, checks);
  std::vector<int> joints;
  for (int joint = 0; joint < m.njnt; ++joint) {
    bool is_testing = false;
    for (int i = 0; i < m.neq; ++i) is_testing |= equalities.IsTestedBy(i, joint);
    const bool is_skipped = std::ranges::any_of(checks.joints, [&](const model::JointCheck& check) {
      return !check.skip.empty() && entries.Names(check, joint);
    });
    if (is_testing && !is_skipped && !PathsOf(m, joint, compiled::StartOf(m)).empty())
      joints.push_back(joint);
  }
  return joints;
}

/// Drives a joint without its own friction, damping and spring, because a hand that moves the joint
/// would overcome them.
DrivenJoint Drive(mjModel& m, mjData& d, int joint) {
  const int dof = m.jnt_dofadr[joint];
  double* const own[] = {m.dof_damping + dof, m.dof_frictionloss + dof, m.jnt_stiffness + joint};
  double saved[std::size(own)];
  for (std::size_t i = 0; i < std::size(own); ++i) saved[i] = std::exchange(*own[i], 0.0);
  JointController controller(m, d, CoupledJoints::kPassive);
  controller.Begin(compiled::StartOf(m));
  DrivenJoint driven = controller.Run(std::span(&joint, 1)).front();
  for (std::size_t i = 0; i < std::size(own); ++i) *own[i] = saved[i];
  return driven;
}

}  // namespace

std::vector<EqualityDrive> DriveEqualities(const mjModel& m, mjData& d, std::string_view object,
                                           const model::Checks& checks) {
  std::vector<EqualityDrive> drives;
  const Equalities equalities(m);
  const std::vector<int> joints = TestingJoints(m, equalities, object, checks);
  if (!checks.drive || joints.empty()) return drives;
  const engine::Model held = HeldModel(m);
  for (const int joint : joints) {
    const DrivenJoint driven = Drive(*held, d, joint);
    for (int i = 0; i < m.neq; ++i) {
      if (!equalities.IsTestedBy(i, joint) || driven.has_diverged) continue;
      auto found = std::ranges::find(drives, i, &EqualityDrive::equality);
      if (found == drives.end()) {
        found = drives.insert(found, {.equality = i, .measured = {}, .driven = joint});
        found->measured.name = compiled::NameOf(m, mjOBJ_EQUALITY, i);
        equalities.FindOutside(*found);
        found->is_reversed = equalities.IsReversed(i);
      }
      const double error = driven.equality_errors[Index(i)];
      if (error <= found->measured.error) continue;
      found->driven = joint;
      found->measured.error = error;
      const double scale = equalities.ScaleOf(i);
      found->measured.share = scale > 0 ? error / scale : 0;
    }
  }
  std::ranges::sort(drives, {}, &EqualityDrive::equality);
  return drives;
}

}  // namespace mjforge::physics
