// Reader of the shapes of the room `solid`.

#pragma once

#include <optional>
#include <string_view>

#include "mjforge/assemble/shape_reader.h"

namespace mjforge::assemble {

/// Returns true if the room `solid` makes parts of this type with these keys.
bool IsSolid(std::string_view type, const spec::Entry& entry);

/// Reads a part that the room `solid` makes, adds its shape by Assets::AddShape, sets the part's
/// pieces, and turns its frame to the grain of the texture. `half_length` (m) has a value only for
/// a box or cylinder with `fromto`.
bool ReadSolid(FieldReader& reader, const spec::Entry& entry, std::string_view type,
               const std::optional<double>& half_length, const PartTexture& texture, Assets& assets,
               model::Part& part, ShapePlacement& placed);

}  // namespace mjforge::assemble
