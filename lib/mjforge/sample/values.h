// Values of a spec for one variant: parameter values, lists, points, loop ranges; rounding of
// draws.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "mjforge/diag/diag.h"

namespace mjforge::sample {

using Numbers = boost::container::small_vector<double, 6>;

/// A number that could not be computed. The reason was already reported in a finding.
inline constexpr double kFailedNumber = std::numeric_limits<double>::quiet_NaN();

/// Returns true if any of the numbers could not be computed (kFailedNumber).
template <typename Range>
bool HasFailedNumber(const Range& numbers) {
  return std::ranges::any_of(numbers, [](double number) { return std::isnan(number); });
}

/// A parameter's value: a number, a boolean, a text, a vector or a list of numbers, a list of texts
/// or of booleans.
using ParameterValue = std::variant<double, bool, std::string, std::vector<double>,
                                    std::vector<std::string>, std::vector<bool>>;

/// Rounds a number drawn from [lo, hi] to 6 significant digits, or to a millionth of hi - lo if
/// that is finer. The result is always in [lo, hi]. An infinite bound means that there is no bound.
double RoundWithin(double lo, double hi, double value);

/// The evaluated items of a list.
struct Items {
  std::vector<double> numbers;     // texts by expr::TextKey(); true is 1, false is 0
  std::vector<std::string> texts;  // texts of the items; empty for a list of other values
};

/// A list of points, and the position of each point in the spec's text.
struct PointList {
  std::size_t per_point = 2;  // number of coordinates per point
  Numbers numbers;
  std::vector<diag::SourceMark> marks;
};

/// The outline of a hole along an axis. Axis 0, 1 or 2 is x, y or z.
struct HoleOutline {
  PointList points;
  std::size_t axis = 2;
};

/// The saved value of a variable. For a text, `number` is the TextKey() of `text`.
struct SavedVariable {
  int slot = 0;
  double number = 0;
  std::string text = {};
};
using SavedVariables = std::vector<SavedVariable>;

/// The values of a loop's variable.
struct LoopRange {
  std::size_t count = 0;
  std::optional<Items> items;  // nullopt: the variable is 0, 1, 2, ...
};

}  // namespace mjforge::sample
