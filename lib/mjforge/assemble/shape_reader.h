// Reader of a part's shape and of the pose of the shape.

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "mjforge/assemble/assets.h"
#include "mjforge/assemble/field_reader.h"
#include "mjforge/assemble/grain.h"

namespace mjforge::assemble {

/// Pose X_FG of a part's shape. G is the frame of the shape; F is the frame in which the spec gives
/// the part's pose. `pieces` contains the convex pieces that collide in place of the part, with
/// poses in G. The list is empty for MuJoCo's own shapes, single convex meshes and mesh files.
struct ShapePlacement {
  model::Pose X_FG;
  std::vector<model::Part> pieces;
};
/// Reads the shape of a part: sets the type, size and mesh in `part`. Names of mesh files are
/// relative to `folder`. Returns nullopt after adding a finding.
std::optional<ShapePlacement> ReadShape(FieldReader& reader, const spec::Entry& entry,
                                        const std::filesystem::path& folder, PartTexture texture,
                                        Assets& assets, model::Part& part);

/// Returns the geom type for a word of the key `type`; kMesh for mesh files and for shapes that the
/// library `solid` makes.
model::GeomType TypeOf(std::string_view word);

}  // namespace mjforge::assemble
