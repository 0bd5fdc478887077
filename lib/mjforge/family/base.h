// Edits of the text of a family's base MJCF, which is the MJCF of one variant. The edits are made
// line by line, because the writer of MJCF puts each element on a line of its own.

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
struct NewPlace {
  std::string_view tag;    // geom, site, joint or inertial
  std::size_t number = 0;  // index among the elements with this tag, in file order
  Eigen::Vector3d pos;
  std::optional<Eigen::Vector4d> quat;
};

/// Returns the base MJCF with these poses in place of its own.
std::string WithPlaces(std::string_view base, std::span<const NewPlace> places);

/// Returns the base MJCF with these values of `frictionloss`, each paired with the name of its
/// joint.
std::string WithFrictions(std::string_view base,
                          std::span<const std::pair<std::string, double>> joints);

/// Returns the base MJCF with the given materials and their textures; adds those that are missing.
std::string WithMaterials(std::string_view base, std::span<const Material> materials);

}  // namespace mjforge::family
