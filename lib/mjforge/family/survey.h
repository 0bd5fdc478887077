// Survey of all variants of a family: which numbers vary, all materials, the lengths of lists and
// texts, and the flags for special poses of any variant.

#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "mjforge/family/rows.h"

namespace mjforge::family {

/// Result of reading all variants of a family once.
struct Survey {
  std::uint64_t count = 0;      // number of variants
  std::vector<double> first;    // numbers of the first variant
  std::vector<bool> varies;     // true for each number that differs between variants
  std::vector<unsigned> flags;  // for numbers of kFlag arrays: bit v is set if any flag is v
  std::vector<double> largest;  // largest value of each number in any variant

  /// All materials; the numbers of each are those of the first variant that has the material.
  std::vector<Material> materials;
  std::vector<std::array<bool, 10>> material_varies;  // for each material: numbers that vary
  std::set<std::string> other_textures;  // materials whose texture differs between variants

  struct Parameter {
    std::string name;
    std::size_t kind = 0;           // index of the type in sample::ParameterValue
    std::uint64_t length = 0;       // length of the longest list
    std::uint64_t code_points = 0;  // length of the longest text, in Unicode code points
    bool varies = false;
    sample::ParameterValue first;  // value of the first variant
  };
  std::vector<Parameter> parameters;

  /// Returns the position in `materials` of the variant's material `row.materials[id]`; -1 if `id`
  /// is -1, which means no material.
  double MaterialId(const RowView& row, double id) const;
};

Survey SurveyOf(std::span<RowsFile> files);

}  // namespace mjforge::family
