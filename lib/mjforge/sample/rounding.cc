// Rounding of drawn numbers to few decimal digits.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "mjforge/sample/distributions.h"
#include "mjforge/sample/values.h"

namespace mjforge::sample {
namespace {

constexpr int kSignificantDigits = 6;
constexpr int kMaxExactPower = 22;  // 10^22 is the largest power of ten that is exact as a double
constexpr double kPowersOfTen[kMaxExactPower + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
// Tolerance of the decimal logarithm of an interval's width. A width such as 0.03 - 0.02 differs
// from a power of ten by a rounding error, which must not add a decimal place.
constexpr double kLogTolerance = 1e-9;

// Returns the number of decimal places that resolve a millionth of the width of an interval; minus
// infinity if the width is infinite.
double PlacesFor(double width) {
  if (!std::isfinite(width)) return -std::numeric_limits<double>::infinity();
  return std::ceil(kSignificantDigits - std::log10(width) - kLogTolerance);
}

// Rounds to a multiple of 10^-places. The operands of the last operation are exact, so the result
// is the double nearest to the decimal.
double RoundByScaling(double value, int places) {
  const double power = kPowersOfTen[std::abs(places)];
  const double scaled = places < 0 ? value / power : value * power;
  if (std::abs(scaled) >= kMaxWhole) return value;  // `value` has no digits to round
  const double whole = std::round(scaled);
  return places < 0 ? whole * power : whole / power;
}

// Rounds to `digits` + 1 significant digits. Needed if the power of ten in RoundByScaling() is not
// exact as a double.
double RoundByText(double value, int digits) {
  if (digits >= 16) return value;
  char text[40];
  const auto end =
      std::to_chars(text, text + sizeof(text), value, std::chars_format::scientific, digits).ptr;
  double rounded = value;
  std::from_chars(text, end, rounded);
  return rounded;
}

}  // namespace

double RoundWithin(double lo, double hi, double value) {
  if (!std::isfinite(value)) return value;
  if (value <= lo) return lo;
  if (value >= hi) return hi;
  if (value == 0) return 0;
  const double exponent = std::floor(std::log10(std::abs(value)));
  const int places =
      static_cast<int>(std::max(kSignificantDigits - 1 - exponent, PlacesFor(hi - lo)));
  const double rounded = std::abs(places) <= kMaxExactPower
                             ? RoundByScaling(value, places)
                             : RoundByText(value, places + static_cast<int>(exponent));
  return std::clamp(rounded, lo, hi) + 0.0;  // + 0.0: no negative zero
}

}  // namespace mjforge::sample
