// Properties of all variants of a family together: constant numbers, materials, lengths of texts,
// coincidences.

#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "mjforge/family/rows.h"

namespace mjforge::family {

/// Result of reading all variants once.
struct Survey {
  std::uint64_t count = 0;      // variants
  std::vector<double> first;    // numbers of the first variant
  std::vector<bool> varies;     // for each of these numbers
  std::vector<unsigned> flags;  // for each number of a kFlag array: a bit for each value
  std::vector<double> largest;  // for each number

  /// All materials, in the order of their first variants, with the numbers that they have there.
  std::vector<Material> materials;
  std::vector<std::array<bool, 10>> look_varies;  // for each of their numbers
  std::set<std::string> other_textures;  // materials whose elements differ in more than numbers

  struct Parameter {
    std::string name;
    std::size_t kind = 0;           // index of the type in sample::ParameterValue
    std::uint64_t length = 0;       // longest list
    std::uint64_t code_points = 0;  // longest text
    bool varies = false;
    sample::ParameterValue first;  // value of the first variant
  };
  std::vector<Parameter> parameters;

  /// Position of a material in `materials`.
  double MaterialId(const RowView& row, double id) const;
};

Survey SurveyOf(std::span<RowsFile> files);

}  // namespace mjforge::family
