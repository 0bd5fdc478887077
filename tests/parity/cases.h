// Pairs of reference files and specs that make the same object.

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "mjforge/spec/spec.h"

namespace mjforge::parity {

/// A reference file and the spec that makes the same object.
struct Case {
  std::string_view reference;
  std::string_view spec;  // in the catalogue, or a file of tests/parity/specs
  /// Returns the reference's values of the spec's parameters; nullptr if the spec has none.
  std::vector<spec::Setting> (*pins)(const nlohmann::json& reference) = nullptr;
};
std::span<const Case> Cases();
std::string SpecPath(const Case& one);

}  // namespace mjforge::parity
