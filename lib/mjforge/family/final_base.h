// The base MJCF of a finished family, with all materials and without flags for special poses that
// are wrong for a variant.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "mjforge/family/survey.h"

namespace mjforge::family {

struct FinalBase {
  std::string text;
  /// Elements that are stored even if they are constant, because their numbers in the base differ
  /// from those of the variants: indices of elements by the name of the array.
  std::map<std::string, std::set<std::size_t>> moved;
};

/// Completes the base MJCF of a family's header, and loads the result in MuJoCo. Returns nullopt
/// after adding a finding.
std::optional<FinalBase> Complete(const Header& header, const bytes::Assets& assets,
                                  const Survey& survey, diag::Findings& findings);

}  // namespace mjforge::family
