// Readers of poses: `pos` with an orientation, `fromto`, and directions.

#pragma once

#include <optional>

#include "mjforge/assemble/field_reader.h"

namespace mjforge::assemble {

/// Returns the pose given by `pos` and one of `quat`, `euler`, `axisangle`, `xyaxes` and `zaxis`.
/// Returns nullopt, and adds a finding, if a field is invalid.
std::optional<model::Pose> ReadPose(FieldReader& reader, const spec::Entry& entry);

/// The segment between the two points of `fromto`: the pose of a frame in its middle, whose z axis
/// points from the second point to the first, and half its length in m.
struct Segment {
  model::Pose pose;
  double half_length = 0;
};
/// Reads `fromto`. If `up` is null, the orientation is the smallest rotation that turns z along the
/// segment. Otherwise the y axis is as close to the direction `up` as possible.
std::optional<Segment> ReadFromTo(FieldReader& reader, const spec::Field& field,
                                  const spec::Field* up);

/// Returns the unit vector in the direction of a field's three numbers; nullopt after adding a
/// finding.
std::optional<Eigen::Vector3d> ReadDirection(FieldReader& reader, const spec::Field& field);

}  // namespace mjforge::assemble
