// Reader of a part's shape and pose.

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mjforge/assemble/assets.h"
#include "mjforge/assemble/field_reader.h"
#include "mjforge/assemble/grain.h"

namespace mjforge::assemble {

/// Pose of the frame G of a part's shape; convex pieces in G if the room `solid` makes the shape.
struct ShapePlacement {
  model::Pose X_FG;
  std::vector<model::Part> pieces;
};
/// Sets the part's shape and mesh. Returns nullopt after a finding.
std::optional<ShapePlacement> ReadShape(FieldReader& reader, const spec::Entry& entry,
                                        const std::filesystem::path& folder, PartTexture texture,
                                        Assets& assets, model::Part& part);

/// Returns the geom type for a value of `type:`; shapes of the room `solid` are meshes.
model::GeomType TypeOf(std::string_view word);

}  // namespace mjforge::assemble
