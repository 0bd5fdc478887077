// Reader of the shapes of the room `solid`.

#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "mjforge/assemble/assets.h"

namespace mjforge::assemble {

/// Returns true if the room `solid` makes parts of this type with these keys.
bool IsSolid(std::string_view type, const spec::Entry& entry);

/// Reads such a part and adds it by Assets::AddShape. `half_length` is given for a box or cylinder
/// with `fromto`.
std::optional<std::vector<model::Part>> ReadSolid(FieldReader& reader, const spec::Entry& entry,
                                                  std::string_view type,
                                                  const std::optional<double>& half_length,
                                                  const solid::TextureMapping& texture,
                                                  Assets& assets, model::Part& part);

}  // namespace mjforge::assemble
