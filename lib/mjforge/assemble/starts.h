// Positions and start states of joints that a spec requests.

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Returns the dimension of the position of a hinge or slide.
expr::Dimension PositionDimension(const model::Joint& joint);

/// The position of a joint in `pose:` or `at:`.
struct RequestedPosition {
  std::string joint;  // full name
  std::string shown;  // name as written in the spec
  sample::Numbers numbers;
  const spec::Value* value = nullptr;  // source of the numbers; null if its units were checked
  diag::SourceMark mark;
};

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
