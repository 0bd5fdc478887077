#pragma once

#include <optional>

#include "mjforge/model/field_reader.h"

namespace mjforge::model {

/// The pose from pos and whichever orientation is given; nothing after a finding.
std::optional<Pose> ReadPose(FieldReader& reader, const spec::Entry& entry);

/// The pose and half length that `fromto` gives.
struct Span {
  Pose pose;
  double half_length = 0;
};
/// `up` may be null: then z is turned the shortest way; else y points along it, as far as it can.
std::optional<Span> ReadFromTo(FieldReader& reader, const spec::Field& field,
                               const spec::Field* up);

/// The unit vector along a field's three numbers.
std::optional<Eigen::Vector3d> ReadDirection(FieldReader& reader, const spec::Field& field);

}  // namespace mjforge::model
