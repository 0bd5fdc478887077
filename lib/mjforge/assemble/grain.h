// Direction in which the texture of a part runs: along an axis that the spec names, or its longest
// edge.

#pragma once

#include <optional>

#include <Eigen/Dense>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/model/model.h"
#include "mjforge/solid/solid.h"

namespace mjforge::assemble {

/// A texture of type 2d, as a material applies it. MuJoCo lays it on by the x and y of a geom's
/// frame.
struct PartTexture {
  solid::TextureMapping mapping = {.unit = solid::TextureMapping::Unit::kNone};
  bool is_turned =
      false;  // to the longest edge, as generated textures are: a picture has an upper edge
  std::optional<int> grain = std::nullopt;  // the axis that the spec names: 0, 1 or 2
};

/// Returns the texture of a material; none if it has no texture of type 2d, or `material` is -1.
PartTexture TextureOf(const model::Object& object, int material);

/// Reads `grain:` of a part into `texture`. Returns false after a finding.
bool ReadGrain(FieldReader& reader, const spec::Entry& entry, std::string_view type,
               PartTexture& texture);

/// Returns the orientation q_FG of the frame in which a box is written, so that streaks along y of
/// G run along the grain of a board, and those along z along that of a post. Changes the half sizes
/// from those in F to those in G.
Eigen::Quaterniond TurnToGrain(const PartTexture& texture, Eigen::Vector3d& half);

/// Returns the mapping for a shape of this size in x and y that gets its texture from above.
solid::TextureMapping MappingFromAbove(const PartTexture& texture, const Eigen::Vector2d& size);

}  // namespace mjforge::assemble
