// Couplings of joints by equalities and tendons.
#pragma once

#include <optional>
#include <vector>

#include <mujoco/mujoco.h>

namespace mjforge::physics {

/// Desired motion of a joint at one time.
struct Setpoint {
  double position = 0;      // rad or m
  double speed = 0;         // rad/s or m/s
  double acceleration = 0;  // rad/s^2 or m/s^2
};

/// Equality of two joints: y = poly(x). Positions x and y are relative to the reference pose of the
/// model (qpos0).
struct JointEquality {
  int y = 0;                     // id of joint1
  int x = 0;                     // id of joint2
  const mjtNum* poly = nullptr;  // the five numbers of polycoef

  /// Returns true if y is a linear function of x with a slope other than 0.
  bool IsLinear() const;
  /// Returns y for x = `value`.
  double At(double value) const;
  /// Returns the derivative dy/dx for x = `value`.
  double SlopeAt(double value) const;
};

/// Returns the equality with this id, which must be of type joint and have a joint 2.
JointEquality JointEqualityAt(const mjModel& m, int equality);

/// Joints of a model that equalities and tendons couple to other joints. `m` must outlive this
/// object.
class JointCouplings {
 public:
  explicit JointCouplings(const mjModel& m);

  /// Returns true if an equality or a tendon may couple the joint to other joints.
  bool IsCoupled(int joint) const { return coupled_[static_cast<std::size_t>(joint)]; }

  /// Returns the motion of the joint `joint` that an equality requires if the joint `driven` is at
  /// `target`; nullopt if no equality of these two joints determines the motion. Positions are
  /// relative to qpos0.
  std::optional<Setpoint> SetpointOf(int joint, int driven, const Setpoint& target) const;

 private:
  std::vector<bool> coupled_;
  std::vector<JointEquality> equalities_;
};

}  // namespace mjforge::physics
