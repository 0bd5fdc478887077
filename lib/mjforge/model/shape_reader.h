// Reader of a part's shape and pose.

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mjforge/model/assets.h"
#include "mjforge/model/field_reader.h"

namespace mjforge::model {

/// Pose of a part's shape, and convex pieces in G if it is a shape of the room `solid`.
struct ShapePlacement {
  Pose X_FG;
  std::vector<Part> pieces;
};
/// Sets the part's shape and mesh. `texture` is the mapping for shapes with texture coordinates.
/// Returns nothing after a finding.
std::optional<ShapePlacement> ReadShape(FieldReader& reader, const spec::Entry& entry,
                                        const std::filesystem::path& folder,
                                        const solid::TextureMapping& texture, Assets& assets,
                                        Part& part);

/// Returns the geom type for a value of `type:`; shapes of the room `solid` are meshes.
GeomType TypeOf(std::string_view word);

}  // namespace mjforge::model
