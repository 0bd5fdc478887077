#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "mjforge/model/assets.h"

namespace mjforge::model {

/// Whether a part of that type, with those keys, is made by the solid room.
bool IsSolid(std::string_view type, const spec::Entry& entry);

/// Reads such a part; see Assets::AddShape. `half_length`: of a box or cylinder with `fromto`.
/// `texture`: what its coordinates are for.
std::optional<std::vector<Part>> ReadSolid(FieldReader& reader, const spec::Entry& entry,
                                           std::string_view type,
                                           const std::optional<double>& half_length,
                                           const solid::TextureMapping& texture, Assets& assets,
                                           Part& part);

}  // namespace mjforge::model
