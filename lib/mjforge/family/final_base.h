// The final base MJCF of a family: has the materials of all variants, and makes MuJoCo set no flag
// for special poses (coincidences.h) that is wrong for any variant.

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "mjforge/family/survey.h"

namespace mjforge::family {

struct FinalBase {
  std::string text;
  /// Indices of elements, by the name of an array, that are stored in the .npz file even if all
  /// variants have the same numbers, because the numbers in the base are different.
  std::map<std::string, std::set<std::size_t>> moved;
};

/// Makes the final base MJCF from the base in a family's header. Checks the result by loading it in
/// MuJoCo. Returns nullopt after adding a finding.
std::optional<FinalBase> Complete(const Header& header, const bytes::Assets& assets,
                                  const Survey& survey, diag::Findings& findings);

}  // namespace mjforge::family
