// Positions and start states of joints that a spec requests.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// The position of a joint in `pose:` or `at:`.
struct RequestedPosition {
  std::string joint;  // full name
  std::string shown;  // name as written in the spec
  sample::Numbers numbers;
  /// Dimensions of the numbers and of all options of a choice; empty if they were checked before.
  expr::Dimensions dimensions;
  diag::SourceMark mark;
};

/// Appends the dimensions of a value's numbers, and of the options of a choice.
void AddDimensions(const spec::Value& value, expr::Dimensions& dimensions);

/// A start state that an entry of `pose:`, or `start:` of a joint, requests for a joint or an
/// actuator.
struct RequestedStart {
  std::string_view key = "pose";
  RequestedPosition position;           // `joint` may be the name of an actuator
  std::optional<Eigen::Vector3d> p;     // only for a free body
  std::optional<Eigen::Quaterniond> q;  // only for a free body
  sample::Numbers velocity = {};
  bool is_actuator = false;
  std::optional<double> ctrl = {};
  std::optional<double> act = {};
};

}  // namespace mjforge::assemble
