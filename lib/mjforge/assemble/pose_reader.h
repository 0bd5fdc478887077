// Readers of poses: pos with an orientation, fromto, directions.

#pragma once

#include <optional>

#include "mjforge/assemble/field_reader.h"

namespace mjforge::assemble {

/// Returns the pose given by pos and one of quat, euler, axisangle, xyaxes and zaxis; nullopt after
/// a finding.
std::optional<model::Pose> ReadPose(FieldReader& reader, const spec::Entry& entry);

/// The segment that `fromto` gives: pose of its middle, with z along it, and half its length, m.
struct Segment {
  model::Pose pose;
  double half_length = 0;
};
/// Reads `fromto`. If `up` is null, the rotation that turns z is the smallest one; otherwise the y
/// axis is as close to `up` as possible.
std::optional<Segment> ReadFromTo(FieldReader& reader, const spec::Field& field,
                                  const spec::Field* up);

/// Returns the unit vector along a field's three numbers; nullopt after a finding.
std::optional<Eigen::Vector3d> ReadDirection(FieldReader& reader, const spec::Field& field);

}  // namespace mjforge::assemble
