// Drives the joints that equality constraints couple, and reports the constraints that slip.
#include "mjforge/physics/model_checks.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/held_model.h"
#include "mjforge/physics/joint_checks.h"
#include "mjforge/physics/joint_controller.h"
#include "mjforge/physics/joint_paths.h"

namespace mjforge::physics {
namespace {

using compiled::Index;
using compiled::Moves;
using expr::RoundedText;

/// An equality constraint and its largest error.
struct EqualityDrive {
  int equality = 0;
  Result::Equality measured;
  int driven = 0;  // id of the joint that was driven when the error was largest
  /// Joint of the equality that would have to leave its range while the other joint of the equality
  /// moves through its range; -1: none.
  int outside_joint = -1;
  double outside = 0;        // distance of outside_joint from its range, rad or m
  double outside_error = 0;  // error of the equality if outside_joint stays in its range
  /// True if the equality would be stiffer with joint1 and joint2 exchanged.
  bool is_reversed = false;
};

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
    const int type = m_.eq_type[equality];
    if (type == mjEQ_JOINT)
      return second >= 0 && (joint == second || (joint == first && IsLinear(equality)));
    if (!IsLimited(joint)) return false;
    if (type == mjEQ_TENDON) return IsOnTendon(m_, joint, first) || IsOnTendon(m_, joint, second);
    if (type != mjEQ_CONNECT && type != mjEQ_WELD) return false;
    const auto [body1, body2] = engine::BodiesOfEquality(m_, equality);
    return Moves(m_, joint, body1) || Moves(m_, joint, body2);
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
std::vector<int> TestingJoints(const ModelTest& test, const Equalities& equalities) {
  const mjModel& m = test.m;
  const model::Checks& checks = test.checks();
  const JointChecks entries(m, test.object.name, checks);
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

/// Drives the joints that test active equalities: for an equality of two joints, joint 2, and also
/// joint 1 if the polynomial is linear; for other equalities, each limited joint that the equality
/// couples. Drives joints like DriveJoints(), but with gravity and with the friction, damping and
/// springs of all joints except the driven joint. Only the equalities move the coupled joints.
std::vector<EqualityDrive> DriveEqualities(const ModelTest& test) {
  const mjModel& m = test.m;
  std::vector<EqualityDrive> drives;
  const Equalities equalities(m);
  const std::vector<int> joints = TestingJoints(test, equalities);
  if (!test.checks().drive || joints.empty()) return drives;
  mjData& d = test.workspace.For(m);
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

std::string MessageOf(const ModelTest& test, const EqualityDrive& drive) {
  const mjModel& m = test.m;
  const bool is_of_joints = m.eq_type[drive.equality] == mjEQ_JOINT;
  const int first = m.eq_obj1id[drive.equality];
  const double error = drive.measured.error;
  return fmt::format(
      "equality '{}' slips by {}, {} % of {}, as joint '{}' is driven", drive.measured.name,
      is_of_joints ? test.Distance(first, error) : fmt::format("{} mm", RoundedText(1000 * error)),
      RoundedText(100 * drive.measured.share),
      is_of_joints ? fmt::format("the way of joint '{}'", test.JointName(first))
                   : "the object's size",
      test.JointName(drive.driven));
}

std::string RemedyOf(const ModelTest& test, const EqualityDrive& drive) {
  const mjModel& m = test.m;
  const int first = m.eq_obj1id[drive.equality];
  if (drive.outside_joint >= 0 && drive.outside_error >= drive.measured.error / 2) {
    return fmt::format(
        "joint '{}' would have to go {} beyond its range: look at the range, and at the ratio, "
        "which is m or rad for each m or rad of the other joint, not for each turn",
        test.JointName(drive.outside_joint), test.Distance(drive.outside_joint, drive.outside));
  }
  if (drive.is_reversed) {
    const mjtNum* poly = m.eq_data + mjNEQDATA * drive.equality;
    return fmt::format(
        "exchange the joints: `joint1: {}, joint2: {}, polycoef: [{}, {}, 0, 0, 0]`; MuJoCo makes "
        "an equality as soft as the lighter joint needs, which must be joint1",
        test.JointName(m.eq_obj2id[drive.equality]), test.JointName(first),
        poly[0] == 0 ? "0" : RoundedText(-poly[0] / poly[1]), RoundedText(1 / poly[1]));
  }
  return "bring solimp closer to 1 (`solimp: [0.99, 0.999, 0.001]`), give the lighter joint an "
         "armature, or look for something in the way";
}

}  // namespace

void CheckEqualities(const ModelTest& test) {
  for (const EqualityDrive& drive : DriveEqualities(test)) {
    test.result.equalities.push_back(drive.measured);
    if (!(drive.measured.share > test.checks().equality_error)) continue;
    test.reporter.Error(diag::Code::kPhysicsEqualitySlips,
                        test.ElementMark("equality", drive.measured.name), MessageOf(test, drive),
                        RemedyOf(test, drive));
  }
}

}  // namespace mjforge::physics
