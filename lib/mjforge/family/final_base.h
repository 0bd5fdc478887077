// The base MJCF of a finished family: all materials, and values that no variant's coincidences
// contradict.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "mjforge/family/survey.h"

namespace mjforge::family {

struct FinalBase {
  std::string text;
  /// Elements that are stored even if they are constant, by array, because the base has another
  /// value: numbers of elements.
  std::map<std::string, std::set<std::size_t>> moved;
};

/// Completes the base, and loads it in MuJoCo. Returns nothing after adding a finding.
std::optional<FinalBase> Complete(const Header& header, const bytes::Assets& assets,
                                  const Survey& survey, diag::Findings& findings);

}  // namespace mjforge::family
