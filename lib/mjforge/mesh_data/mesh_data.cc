// Selection of the check for a mesh or skin file by its format, and parsing of numbers.
#include "mjforge/mesh_data/mesh_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/mesh_data/formats.h"

namespace mjforge::mesh_data {

std::optional<Format> FormatOf(std::string_view file_name) {
  const std::string ending = diag::LowerCase(
      file_name.substr(file_name.size() - std::min<std::size_t>(3, file_name.size())));
  if (ending == "obj") return Format::kObj;
  if (ending == "stl") return Format::kStl;
  if (ending == "msh") return Format::kMsh;
  if (ending == "skn") return Format::kSkn;
  return std::nullopt;
}

Check CheckFile(Format format, std::string_view content) {
  // In the order of Format.
  constexpr Check (*kChecks[])(std::string_view) = {CheckObj, CheckStl, CheckMsh, CheckSkn};
  return kChecks[static_cast<std::size_t>(format)](content);
}

bool IsFiniteFloat(double number) {
  return std::abs(number) <= double{std::numeric_limits<float>::max()};
}

std::optional<double> ParseInteger(std::string_view word) {
  std::string_view digits = word;
  if (digits.starts_with('-') || digits.starts_with('+')) digits.remove_prefix(1);
  if (digits.empty() || !std::ranges::all_of(digits, expr::IsDigit)) return std::nullopt;
  return expr::ParseNumber(word);
}

}  // namespace mjforge::mesh_data
