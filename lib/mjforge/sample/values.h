#pragma once

// What values of a spec become when they are drawn.

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "mjforge/diag/diag.h"

namespace mjforge::sample {

using Numbers = boost::container::small_vector<double, 6>;

/// A parameter's value: a number, a boolean, a text, a vector or a list of numbers, a list of
/// texts.
using ParameterValue =
    std::variant<double, bool, std::string, std::vector<double>, std::vector<std::string>>;

/// Rounds what is drawn from [lo, hi]: to 6 significant digits, never coarser than a millionth of
/// hi - lo, never outside. Infinite bounds mean "no bound".
class Rounding {
 public:
  Rounding(double lo, double hi);
  double operator()(double value) const;

 private:
  double lo_;
  double hi_;
  double places_;  // decimal ones that a millionth of the range has
};

/// The values of a list.
struct Items {
  Numbers numbers;                 // of texts, their TextKey()s
  std::vector<std::string> texts;  // none if it is of numbers
};

/// Points, and where in the spec each comes from.
struct PointList {
  std::size_t per_point = 2;  // numbers
  Numbers numbers;
  std::vector<diag::SourceMark> marks;
};

/// What a loop's variable runs over.
struct LoopRange {
  std::size_t count = 0;
  std::optional<Items> items;  // nothing: 0, 1, 2, ...
};

}  // namespace mjforge::sample
