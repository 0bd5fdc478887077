// Parsed sections `expect:` and `checks:`, the conditions that a spec sets for its objects.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/entry.h"
#include "mjforge/spec/values.h"

namespace mjforge::spec {

/// Position that a spec gives for a joint (its qpos in MuJoCo): an entry of `at:` of an expectation
/// or a check, or an entry of `pose:` of an object or a view.
struct JointPosition {
  Value joint;  // a text: the joint's name
  diag::SourceMark mark;
  Value value;  // a number (m or rad), or the quaternion of a ball joint
};

enum class ExpectationKind { kThat, kGap, kTouch, kApart, kInside };

/// A condition that every variant must meet: an entry of `expect:`.
struct Expectation {
  Entry entry;  // keys `if`, `for`, `let`; `fields` contains `min` and `max`
  ExpectationKind kind = ExpectationKind::kThat;
  std::optional<expr::Expression> condition;  // only for kThat
  std::vector<Value> names;                   // for all other kinds: names of two bodies or parts
  std::vector<JointPosition> at;
  std::string doc;
};

/// The section `checks:`, after settings (`checks.KEY`) have replaced some of its values.
struct Checks {
  std::vector<Field> fields;
  struct Silence {
    diag::Code code{};
    std::string reason;
  };
  std::vector<Silence> silenced;
  struct Group {
    std::vector<Field> fields;
    diag::SourceMark mark;
  };
  std::optional<Group> holds;
  std::optional<Group> settled;
  struct JointCheck {
    Entry entry;                // keys `if`, `for`, `let`; `fields` contains the thresholds
    std::vector<Value> joints;  // texts: names of joints
    std::vector<JointPosition> at;
    std::string skip;
  };
  std::vector<JointCheck> joints;
  struct Fitting {
    Entry entry;  // keys `if`, `for`, `let`; `fields` contains all other keys
  };
  std::vector<Fitting> fits;
  struct Grasping {
    std::vector<Field> fields;
    std::vector<Value> sites;  // texts: names of sites
    diag::SourceMark mark;
  };
  std::optional<Grasping> grasps;
  struct PartCheck {
    Entry entry;               // keys `if`, `for`, `let`; `fields` contains the limits
    std::vector<Value> parts;  // texts: names of parts
  };
  std::vector<PartCheck> parts;
};
/// Returns true for findings that `checks: {silence: ...}` accepts: those of physical checks
/// (physics/...), and spec/unused.
bool CanBeSilenced(diag::Code code);

}  // namespace mjforge::spec
