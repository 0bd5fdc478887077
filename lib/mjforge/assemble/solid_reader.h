// Reader of parts whose shapes the library `solid` makes (lathe, prism, tube, hull, rounded box,
// ...).

#pragma once

#include <optional>
#include <string_view>

#include "mjforge/assemble/shape_reader.h"

namespace mjforge::assemble {

/// Returns true if the library `solid` makes the shape of the entry: a lathe, prism, tube or hull,
/// a box with `round` or `holes`, or a cylinder with `round`.
bool IsSolid(std::string_view type, const spec::Entry& entry);

/// Reads a part that the library `solid` makes, and adds its shape with Assets::AddShape(). Sets
/// the convex pieces in `placed`, and turns the frame of a rounded box to the grain of its texture.
/// `half_length` (m) has a value only for a box or cylinder with `fromto`. Returns false after
/// adding a finding.
bool ReadSolid(FieldReader& reader, const spec::Entry& entry, std::string_view type,
               const std::optional<double>& half_length, const PartTexture& texture, Assets& assets,
               model::Part& part, ShapePlacement& placed);

}  // namespace mjforge::assemble
