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

/// A number that could not be computed. Its finding has been added.
inline constexpr double kFailedNumber = std::numeric_limits<double>::quiet_NaN();

/// Returns true if any of the numbers failed.
template <typename Range>
bool HasFailedNumber(const Range& numbers) {
  return std::ranges::any_of(numbers, [](double number) { return std::isnan(number); });
}

/// A parameter's value: a number, a boolean, a text, a vector or a list of numbers, a list of texts
/// or of booleans.
using ParameterValue = std::variant<double, bool, std::string, std::vector<double>,
                                    std::vector<std::string>, std::vector<bool>>;

/// Rounds a number drawn from [lo, hi] to 6 significant digits, or to a millionth of hi - lo if
/// that is finer. The result is never outside [lo, hi]. Infinite bounds mean "no bound".
double RoundWithin(double lo, double hi, double value);

/// The values of a list.
struct Items {
  std::vector<double> numbers;     // TextKey() of a text; 1 for true, 0 for false
  std::vector<std::string> texts;  // empty for a list of other values
};

/// A list of points, and the place in the spec that each point comes from.
struct PointList {
  std::size_t per_point = 2;  // coordinates of each point
  Numbers numbers;
  std::vector<diag::SourceMark> marks;
};

/// The outline of a hole along an axis: 0, 1 and 2 are x, y and z.
struct HoleOutline {
  PointList points;
  std::size_t axis = 2;
};

/// The saved value of a variable; `number` is the TextKey() of `text` if the variable is a text.
struct SavedVariable {
  int slot = 0;
  double number = 0;
  std::string text = {};
};
using SavedVariables = std::vector<SavedVariable>;

/// The values that a loop's variable takes.
struct LoopRange {
  std::size_t count = 0;
  std::optional<Items> items;  // nullopt: the variable is 0, 1, 2, ...
};

}  // namespace mjforge::sample
