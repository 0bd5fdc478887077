// Grain of a part: the direction of its texture, along an axis that the spec specifies, or along
// the longest edge.

#pragma once

#include <optional>

#include <Eigen/Dense>

#include "mjforge/assemble/field_reader.h"
#include "mjforge/model/model.h"
#include "mjforge/solid/solid.h"

namespace mjforge::assemble {

/// A texture of type "2d" with the mapping of its material. MuJoCo computes the texture coordinates
/// from x and y in the geom's frame.
struct PartTexture {
  solid::TextureMapping mapping = {.unit = solid::TextureMapping::Unit::kNone};
  /// True if, unless `grain` is set, the grain follows the longest edge of the part. False with
  /// `grain: none`, and for image files, because a picture has a definite top edge.
  bool is_turned = false;
  std::optional<int> grain = std::nullopt;  // axis that the spec specifies: 0, 1 or 2
};

/// Returns the texture of a material. The unit of its mapping is kNone if `material` is -1 or has
/// no texture of type "2d".
PartTexture TextureOf(const model::Object& object, int material);

/// Reads `grain:` of a part into `texture`. Returns false after adding a finding.
bool ReadGrain(FieldReader& reader, const spec::Entry& entry, std::string_view type,
               PartTexture& texture);

/// Returns the orientation q_FG of the box geom's frame G relative to the frame F, in which the
/// spec gives the box. In a board (flat box), y of G is along the grain; in a post, z of G is.
/// Converts the half sizes `half` from F to G.
Eigen::Quaterniond TurnToGrain(const PartTexture& texture, Eigen::Vector3d& half);

/// Returns the mapping of a texture that is projected from above onto a shape of this size in x and
/// y.
solid::TextureMapping MappingFromAbove(const PartTexture& texture, const Eigen::Vector2d& size);

}  // namespace mjforge::assemble
