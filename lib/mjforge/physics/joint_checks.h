// Entries of checks.joints, applied to the joints of a compiled model.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::physics {

/// Finds the joints that entries of checks.joints name, with or without "OBJECT_" in front of the
/// name. `m` and `checks` must outlive this object.
class JointChecks {
 public:
  JointChecks(const mjModel& m, std::string_view object, const model::Checks& checks)
      : m_(m), object_(object), checks_(checks) {}

  /// Reports joints that the model does not have, impossible positions, and `rests` of joints that
  /// are neither hinges nor slides. Returns false after a report; then no other function may be
  /// called.
  bool Verify(static_checks::Reporter& reporter) const;

  /// Returns the joints that can be driven and that no entry of checks.joints names.
  std::vector<int> Others() const;

  /// Returns the ids of the joints that an entry of checks.joints names, except joints that cannot
  /// be driven.
  std::vector<int> JointsOf(const model::JointCheck& check) const;

  /// Returns true if the drive test can move the joint from the start pose of the model, with or
  /// without an actuator. Free joints and slides without a range cannot be driven.
  bool CanBeDriven(int joint) const;

  /// Returns true if `check`, an entry of checks.joints, names the joint.
  bool Names(const model::JointCheck& check, int joint) const;

  /// Returns the positions (qpos) from which the joints of an entry of checks.joints are driven:
  /// the start pose, changed by `at` of the entry.
  std::vector<mjtNum> StartOf(const model::JointCheck& check) const;

 private:
  std::optional<int> Find(const std::string& joint) const;

  const mjModel& m_;
  std::string object_;  // name of the object
  const model::Checks& checks_;
};

}  // namespace mjforge::physics
