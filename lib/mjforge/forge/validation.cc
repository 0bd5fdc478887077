#include <algorithm>
#include <array>

#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"none", "load", "physics"};

}  // namespace

std::span<const std::string_view> ValidationNames() { return kNames; }

std::string_view NameOf(Validation validation) {
  return kNames[static_cast<std::size_t>(validation)];
}

std::optional<Validation> FindValidation(std::string_view name) {
  const auto* found = std::ranges::find(kNames, name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Validation>(found - kNames.begin());
}

}  // namespace mjforge::forge
