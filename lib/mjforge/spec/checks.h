#pragma once

// What a spec demands of its objects: `expect:` and `checks:`.

#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/spec/entry.h"
#include "mjforge/spec/values.h"

namespace mjforge::spec {

/// One of `pose:`: where a joint stands at the start, as qpos has it.
struct JointPosition {
  Value joint;  // text
  diag::SourceMark mark;
  Value value;  // a number, or four
};

enum class ExpectationKind { kThat, kGap, kTouch, kApart, kInside };

/// One of `expect:`.
struct Expectation {
  Entry entry;  // if, for, let; min and max as fields
  ExpectationKind kind = ExpectationKind::kThat;
  std::optional<expr::Expression> condition;  // kThat
  std::vector<Value> names;                   // of the other kinds: two bodies or parts
  std::vector<JointPosition> at;
  std::string doc;
};

/// `checks:`, including the values set from outside.
struct Checks {
  std::vector<Field> fields;
  struct Silence {
    diag::Code code{};
    std::string reason;
  };
  std::vector<Silence> silenced;
  struct Holding {
    std::vector<Field> fields;
    diag::SourceMark mark;
  };
  std::optional<Holding> holds;
  struct JointCheck {
    Entry entry;                // if, for, let; thresholds as fields
    std::vector<Value> joints;  // texts
    std::vector<JointPosition> at;
    std::string skip;
  };
  std::vector<JointCheck> joints;
  struct Fitting {
    Entry entry;  // if, for, let; all else as fields
  };
  std::vector<Fitting> fits;
  struct Grasping {
    std::vector<Field> fields;
    std::vector<Value> sites;  // texts
    diag::SourceMark mark;
  };
  std::optional<Grasping> grasps;
  struct PartCheck {
    Entry entry;               // if, for, let; limits as fields
    std::vector<Value> parts;  // texts
  };
  std::vector<PartCheck> parts;
};
/// Whether findings of a code may be intended: how an object behaves, what a spec does not use.
bool CanBeSilenced(diag::Code code);

}  // namespace mjforge::spec
