// Edits of the base MJCF of a family. The base MJCF is the edited MJCF text of one variant;
// simulators load this text for all variants of the family. The edits are made line by line,
// because the writer of MJCF puts each element on a line of its own.

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

/// A new pose of an element in its body, which replaces `pos` and, if it is given, `quat`.
struct NewPose {
  std::string_view tag;    // geom, site, joint or inertial
  std::size_t number = 0;  // index among the elements with this tag, in file order
  Eigen::Vector3d pos;
  std::optional<Eigen::Vector4d> quat;
};

/// Returns the base MJCF in which the elements that `poses` selects have these poses.
std::string WithPoses(std::string_view base, std::span<const NewPose> poses);

/// Returns the base MJCF in which the given joints have other values of `frictionloss`. `joints`
/// are pairs of a joint's name and the value.
std::string WithFrictions(std::string_view base,
                          std::span<const std::pair<std::string, double>> joints);

/// Returns the base MJCF with the given materials and their textures; adds those that are missing.
std::string WithMaterials(std::string_view base, std::span<const Material> materials);

}  // namespace mjforge::family
