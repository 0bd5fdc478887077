// Edits of the text of a family's base MJCF: the MJCF of one variant, which simulators load for all
// variants of the family. The edits are made line by line, because the writer of MJCF puts each
// element on a line of its own.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/family/family.h"

namespace mjforge::family {

/// A new pose of an element in its body, which replaces the pose in the text.
struct NewPose {
  std::string_view tag;    // geom, site, joint or inertial
  std::size_t number = 0;  // index among the elements with this tag, in file order
  Eigen::Vector3d pos;
  std::optional<Eigen::Vector4d> quat;
};

/// Returns the base MJCF with the poses of `poses` in place of the elements' own poses.
std::string WithPoses(std::string_view base, std::span<const NewPose> poses);

/// Returns the base MJCF with another `frictionloss` of the joints in `joints`: pairs of a joint's
/// name and the value.
std::string WithFrictions(std::string_view base,
                          std::span<const std::pair<std::string, double>> joints);

/// Returns the base MJCF after adding the given materials and textures that it does not contain.
std::string WithMaterials(std::string_view base, std::span<const Material> materials);

}  // namespace mjforge::family
