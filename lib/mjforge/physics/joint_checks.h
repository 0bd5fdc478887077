#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/model/model.h"
#include "mjforge/physics/verdict.h"

namespace mjforge::physics {

/// What checks.joints say of a model's joints, whose names may begin with the object's. `m` and
/// `checks` must outlive it.
class JointChecks {
 public:
  JointChecks(const mjModel& m, std::string_view object, const model::Checks& checks)
      : m_(m), object_(object), checks_(checks) {}

  /// Reports joints that the model does not have, and positions that they cannot have. False: there
  /// are some, and no other function may be asked.
  bool Verify(Verdict& verdict) const;

  /// Joints that no entry drives or leaves out, and whose range can be driven.
  std::vector<int> Others() const;

  /// Those of an entry whose range can be driven.
  std::vector<int> JointsOf(const model::JointCheck& check) const;

  /// Whether an entry speaks of a joint.
  bool Names(const model::JointCheck& check, int joint) const;

  /// Where joints stand as the entry's are driven, nq numbers.
  std::vector<mjtNum> StartOf(const model::JointCheck& check) const;

 private:
  /// -1: there is none.
  int Find(const std::string& joint) const;
  bool CanBeDriven(int joint) const;

  const mjModel& m_;
  std::string object_;  // its name
  const model::Checks& checks_;
};

}  // namespace mjforge::physics
