// Direction in which the texture of a part runs: along an axis that the spec names, or its longest
// edge.

#pragma once

#include <optional>

#include <Eigen/Dense>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/model/model.h"
#include "mjforge/solid/solid.h"

namespace mjforge::assemble {

/// A texture of type 2d with the mapping of its material. MuJoCo computes the texture coordinates
/// from x and y in a geom's frame.
struct PartTexture {
  solid::TextureMapping mapping = {.unit = solid::TextureMapping::Unit::kNone};
  bool is_turned =
      false;  // along the longest edge; only generated textures, because a picture has a top
  std::optional<int> grain = std::nullopt;  // the axis that the spec names: 0, 1 or 2
};

/// Returns the texture of a material; its unit is kNone if the material is -1 or has no 2d texture.
PartTexture TextureOf(const model::Object& object, int material);

/// Reads `grain:` of a part into `texture`. Returns false after a finding.
bool ReadGrain(FieldReader& reader, const spec::Entry& entry, std::string_view type,
               PartTexture& texture);

/// Returns the orientation q_FG of the frame G in which a box is written: y of G is along the grain
/// of a board, z of G along the grain of a post. Converts the half sizes `half` from F to G.
Eigen::Quaterniond TurnToGrain(const PartTexture& texture, Eigen::Vector3d& half);

/// Returns the mapping for a shape of this size in x and y that gets its texture from above.
solid::TextureMapping MappingFromAbove(const PartTexture& texture, const Eigen::Vector2d& size);

}  // namespace mjforge::assemble
