#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mjforge/model/assets.h"
#include "mjforge/model/field_reader.h"

namespace mjforge::model {

struct PlacedShape {
  Pose X_FG;
  std::vector<Part> pieces;  // of a shape that MuJoCo does not have, in G
};
/// Sets the part's shape. `texture`: the coordinates of a shape that has some. Nothing
/// after a finding.
std::optional<PlacedShape> ReadShape(FieldReader& reader, const spec::Entry& entry,
                                     const std::filesystem::path& folder,
                                     const solid::TextureMapping& texture, Assets& assets,
                                     Part& part);

/// The type that a word of the field table names; prisms and lathes are meshes.
GeomType TypeOf(std::string_view word);

}  // namespace mjforge::model
