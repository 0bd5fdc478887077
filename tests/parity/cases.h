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
  std::string_view spec;  // of the catalogue; or a file of tests/parity/specs
  /// The reference's values for the spec's parameters; nullptr: it has none.
  std::vector<spec::Setting> (*pins)(const nlohmann::json& reference) = nullptr;
};
std::span<const Case> Cases();
std::string SpecPath(const Case& one);

}  // namespace mjforge::parity
