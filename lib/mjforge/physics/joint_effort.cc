// Check of joints and actuators: compares the forces that joints need with those of actuators and
// of a person.
#include "mjforge/physics/model_checks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/engine/engine.h"
#include "mjforge/expr/expr.h"
#include "mjforge/physics/joint_couplings.h"
#include "mjforge/physics/joint_paths.h"

namespace mjforge::physics {
namespace {

using compiled::Index;
using diag::Code;
using expr::RoundedText;

constexpr int kPositions = 9;        // number of positions at which the load of a joint is computed
constexpr double kMostSag = 0.2;     // share of the range by which a servo may give way to a load
constexpr double kMostBeyond = 0.5;  // share of the range by which a setpoint may exceed the range
constexpr double kForceOfPerson = 400;   // N
constexpr double kLongestPush = 10;      // s, longest time from one end of the range to the other
constexpr double kShortestLever = 0.02;  // m, least lever arm of a person at a hinge, as of a knob

class Efforts {
 public:
  Efforts(const ModelTest& test, mjData& d) : test_(test), m_(test.m), d_(d), couplings_(test.m) {}

  void Check() {
    for (int actuator = 0; actuator < m_.nu; ++actuator) CheckActuator(actuator);
    for (int joint = 0; joint < m_.njnt; ++joint) {
      if (compiled::HasOneNumber(m_, joint)) CheckJoint(joint);
    }
  }

 private:
  /// Largest forces on a joint in its negative (`down`) and positive (`up`) direction, N or Nm.
  struct Force {
    double down = 0;
    double up = 0;
  };

  /// Returns the hinge or slide that an actuator moves; nullopt for other transmissions.
  std::optional<int> JointOf(int actuator) const {
    const int type = m_.actuator_trntype[actuator];
    const int joint = m_.actuator_trnid[2 * actuator];
    if (type != mjTRN_JOINT && type != mjTRN_JOINTINPARENT) return std::nullopt;
    return compiled::HasOneNumber(m_, joint) ? std::optional(joint) : std::nullopt;
  }

  double GearOf(int actuator) const { return m_.actuator_gear[6 * actuator]; }
  double GainOf(int actuator) const { return m_.actuator_gainprm[mjNGAIN * actuator]; }

  /// Returns true for a position servo: an actuator whose force is gain * (control - gear *
  /// position), without activation dynamics.
  bool IsServo(int actuator) const {
    return HasFixedGain(actuator) && m_.actuator_biastype[actuator] == mjBIAS_AFFINE &&
           GainOf(actuator) > 0 && m_.actuator_biasprm[mjNBIAS * actuator + 1] == -GainOf(actuator);
  }
  bool IsMotor(int actuator) const {
    return HasFixedGain(actuator) && m_.actuator_biastype[actuator] == mjBIAS_NONE;
  }
  bool HasFixedGain(int actuator) const {
    return m_.actuator_gaintype[actuator] == mjGAIN_FIXED &&
           m_.actuator_dyntype[actuator] == mjDYN_NONE;
  }

  void CheckActuator(int actuator) {
    const std::optional<int> joint = JointOf(actuator);
    if (!joint) return;
    if (GearOf(actuator) == 0) {
      test_.reporter.Warning(
          Code::kPhysicsActuator, MarkOfActuator(actuator),
          fmt::format("actuator '{}' has a gear of 0 and cannot move joint '{}'",
                      ActuatorName(actuator), JointName(*joint)),
          "leave `gear` out, or give it the force on the joint for a control of 1");
      return;
    }
    if (m_.jnt_limited[*joint] == 0 || couplings_.IsCoupled(*joint)) return;
    CheckControlRange(actuator, *joint);
    CheckStrength(actuator, *joint);
  }

  /// Warns of setpoints of a servo far beyond the range of its joint.
  void CheckControlRange(int actuator, int joint) {
    if (!IsServo(actuator) || m_.actuator_ctrllimited[actuator] == 0) return;
    const double gear = GearOf(actuator);
    double beyond = 0;
    double farthest = 0;
    for (int end = 0; end < 2; ++end) {
      const double target = m_.actuator_ctrlrange[2 * actuator + end] / gear;
      const double outside = std::max(Low(joint) - target, target - High(joint));
      if (outside <= beyond) continue;
      beyond = outside;
      farthest = target;
    }
    if (!(beyond > kMostBeyond * (High(joint) - Low(joint)))) return;
    test_.reporter.Warning(
        Code::kPhysicsActuator, MarkOfActuator(actuator),
        fmt::format("actuator '{}' can be set to {}, but joint '{}' only goes from {} to {}",
                    ActuatorName(actuator), Distance(joint, farthest), JointName(joint),
                    Distance(joint, Low(joint)), Distance(joint, High(joint))),
        "the ctrlrange of a position servo is a position, in m or rad");
  }

  /// Warns of an actuator that cannot overcome weight, springs and dry friction at some position in
  /// the range of its joint.
  void CheckStrength(int actuator, int joint) {
    const std::optional<Force> strength = StrengthOf(actuator, joint);
    if (!strength) return;
    double lacking = 0;
    double needed = 0;
    double where = 0;
    for (int i = 0; i < kPositions; ++i) {
      const double at = Low(joint) + (High(joint) - Low(joint)) * i / (kPositions - 1);
      const double load = LoadAt(joint, at);
      const double weak = load > 0 ? load - strength->up : -load - strength->down;
      if (weak <= lacking) continue;
      lacking = weak;
      needed = load;
      where = at;
    }
    if (!(lacking > 1e-9)) return;
    test_.reporter.Warning(
        Code::kPhysicsActuator, MarkOfActuator(actuator),
        fmt::format("actuator '{}' is too weak for joint '{}': it has {} {}, and {} {} are "
                    "needed at {}",
                    ActuatorName(actuator), JointName(joint),
                    RoundedText(needed > 0 ? strength->up : strength->down), Unit(joint),
                    RoundedText(std::abs(needed)), Unit(joint), Distance(joint, where)),
        IsServo(actuator) ? "a larger kp or forcerange, or a lighter body"
                          : "a larger ctrlrange, gear or forcerange, or a lighter body");
  }

  /// Returns the largest forces of an actuator on its joint; nullopt unless the actuator is a motor
  /// or a position servo.
  std::optional<Force> StrengthOf(int actuator, int joint) const {
    const double gear = GearOf(actuator);
    double low = -mjMAXVAL;
    double high = mjMAXVAL;
    if (IsServo(actuator)) {
      const double sag = kMostSag * (High(joint) - Low(joint)) * std::abs(gear);
      low = -GainOf(actuator) * sag;
      high = -low;
    } else if (!IsMotor(actuator)) {
      return std::nullopt;
    } else if (m_.actuator_ctrllimited[actuator] != 0) {
      low = GainOf(actuator) * m_.actuator_ctrlrange[2 * actuator];
      high = GainOf(actuator) * m_.actuator_ctrlrange[2 * actuator + 1];
      if (low > high) std::swap(low, high);
    }
    if (m_.actuator_forcelimited[actuator] != 0) {
      low = std::max(low, m_.actuator_forcerange[2 * actuator]);
      high = std::min(high, m_.actuator_forcerange[2 * actuator + 1]);
    }
    Force force = {-low * gear, high * gear};
    if (gear < 0) force = {high * -gear, -low * -gear};
    return Force{std::max(force.down, 0.0), std::max(force.up, 0.0)};
  }

  /// Returns the force, N or Nm, that holds a joint at rest at `position` against weight and
  /// springs, and overcomes its dry friction; positive in the positive direction of the joint.
  double LoadAt(int joint, double position) {
    compiled::CopyStart(m_, d_);
    std::fill_n(d_.qvel, m_.nv, 0.0);
    d_.qpos[m_.jnt_qposadr[joint]] = position;
    mj_fwdPosition(&m_, &d_);
    mj_fwdVelocity(&m_, &d_);
    const int dof = m_.jnt_dofadr[joint];
    const double load = d_.qfrc_bias[dof] - d_.qfrc_passive[dof];
    return load + std::copysign(m_.dof_frictionloss[dof], load);
  }

  /// Warns of a joint that neither a person nor an actuator can move from end to end within
  /// kLongestPush.
  void CheckJoint(int joint) {
    const std::vector<JointPath> paths = PathsOf(m_, joint, compiled::StartOf(m_));
    if (paths.empty() || couplings_.IsCoupled(joint)) return;
    const int dof = m_.jnt_dofadr[joint];
    const double lever = LeverOf(joint);
    const double person = kForceOfPerson * lever;
    double force = person;
    for (int actuator = 0; actuator < m_.nu; ++actuator) {
      if (JointOf(actuator) != joint) continue;
      const std::optional<Force> strength = StrengthOf(actuator, joint);
      if (strength) force = std::max(force, std::min(strength->up, strength->down));
    }
    const double range = paths.front().range();
    const double needed = m_.dof_frictionloss[dof] + m_.dof_damping[dof] * range / kLongestPush +
                          m_.dof_armature[dof] * 4 * range / (kLongestPush * kLongestPush);
    if (!(needed > force)) return;
    test_.reporter.Warning(
        Code::kPhysicsJointHeavy, test_.JointMark(JointName(joint)),
        fmt::format("joint '{}' can hardly be moved: {} {} are needed to move it by {} in {} s, "
                    "and {} {} are there",
                    JointName(joint), RoundedText(needed), Unit(joint), Distance(joint, range),
                    RoundedText(kLongestPush), RoundedText(force), Unit(joint)) +
            (force == person
                 ? fmt::format(" (a person's {} N{})", RoundedText(kForceOfPerson),
                               IsSlide(joint) ? std::string()
                                              : fmt::format(" at {} mm", RoundedText(1000 * lever)))
                 : std::string()),
        IsSlide(joint) ? "damping is in Ns/m, frictionloss in N, armature in kg"
                       : "damping is in Nms/rad, frictionloss in Nm, armature in kg m^2");
  }

  /// Returns the lever arm, m, at which a person can push a hinge: the distance from the axis to
  /// the farthest corner of the boxes of moved geoms, but at least kShortestLever. Returns 1 for a
  /// slide.
  double LeverOf(int joint) const {
    if (IsSlide(joint)) return 1;
    const std::vector<bool> moved = BodiesMovedBy(m_, joint);
    const Eigen::Vector3d axis = compiled::VectorAt(d_.xaxis, joint);
    const Eigen::Vector3d anchor = compiled::VectorAt(d_.xanchor, joint);
    double lever = kShortestLever;
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      if (!moved[Index(m_.geom_bodyid[geom])] || !compiled::Collides(m_, geom)) continue;
      const Eigen::AlignedBox3d box =
          compiled::GeomBox(m_, geom, compiled::GeomPose(d_, geom)).ToEigen();
      for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3d point =
            box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
        lever = std::max(lever, axis.cross(point - anchor).norm());
      }
    }
    return lever;
  }

  bool IsSlide(int joint) const { return m_.jnt_type[joint] == mjJNT_SLIDE; }
  double Low(int joint) const { return m_.jnt_range[2 * joint]; }
  double High(int joint) const { return m_.jnt_range[2 * joint + 1]; }
  std::string_view Unit(int joint) const { return IsSlide(joint) ? "N" : "Nm"; }
  std::string Distance(int joint, double value) const { return test_.Distance(joint, value); }
  std::string JointName(int joint) const { return test_.JointName(joint); }
  std::string ActuatorName(int actuator) const {
    return compiled::NameOf(m_, mjOBJ_ACTUATOR, actuator);
  }

  diag::SourceMark MarkOfActuator(int actuator) const {
    return test_.ElementMark("actuator", ActuatorName(actuator));
  }

  const ModelTest& test_;
  const mjModel& m_;
  mjData& d_;
  JointCouplings couplings_;
};

}  // namespace

void CheckEfforts(const ModelTest& test) {
  mjData& d = test.workspace.For(test.m);
  compiled::CopyStart(test.m, d);
  mj_kinematics(&test.m, &d);
  Efforts(test, d).Check();
}

}  // namespace mjforge::physics
