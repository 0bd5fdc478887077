// Settings with which variants of a bundled spec take little time.

#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mjforge::harness {

/// Returns names and values for `--set`: a pile of all its things takes seconds to come to rest.
inline std::vector<std::pair<std::string, std::string>> QuickSettings(std::string_view spec) {
  if (spec.find("bin_pile") == spec.npos) return {};
  return {{"kinds", "1"}};
}

/// Returns the same as options of a command.
inline std::vector<std::string> QuickOptions(std::string_view spec) {
  std::vector<std::string> options;
  for (const auto& [name, value] : QuickSettings(spec)) {
    options.emplace_back("--set");
    options.push_back(name + "=" + value);
  }
  return options;
}

}  // namespace mjforge::harness
