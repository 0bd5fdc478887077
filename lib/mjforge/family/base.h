// The base MJCF of a family: a variant's text, changed line by line. The writer of MJCF puts each
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

/// A place of an element in its body that replaces the one in the text.
struct NewPlace {
  std::string_view tag;    // geom site joint inertial
  std::size_t number = 0;  // among the elements with this tag, from the top; of its body: inertial
  Eigen::Vector3d pos;
  std::optional<Eigen::Vector4d> quat;
};

/// Returns the base with these places.
std::string WithPlaces(std::string_view base, std::span<const NewPlace> places);

/// Returns the base with these values of `frictionloss`; joints by name.
std::string WithFrictions(std::string_view base,
                          std::span<const std::pair<std::string, double>> joints);

/// Returns the base with the materials that it does not have.
std::string WithMaterials(std::string_view base, std::span<const Material> materials);

}  // namespace mjforge::family
