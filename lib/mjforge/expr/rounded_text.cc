// Conversion of numbers, speeds and joint distances to short texts for messages.
#include "mjforge/expr/rounded_text.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {

std::string RoundedText(double value, int digits) {
  constexpr double kLargest = 1e9;  // numbers from this magnitude on may have an exponent
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (text.find("e+") == text.npos || std::abs(value) >= kLargest) return text;
  return fmt::format("{:.0f}", value);
}

std::string SpeedText(double speed) {
  return speed < 1 ? RoundedText(1000 * speed) + " mm/s" : RoundedText(speed) + " m/s";
}

std::string DistanceText(bool is_slide, double distance) {
  return is_slide ? RoundedText(1000 * distance) + " mm"
                  : RoundedText(distance * 180 / std::numbers::pi) + " deg";
}

ExceededLimit::ExceededLimit(double number, double bound) {
  for (int digits = 3; digits <= 17; ++digits) {
    value = RoundedText(number, digits);
    limit = RoundedText(bound, digits);
    const double shown = ParseNumber(value).value_or(number);
    const double shown_limit = ParseNumber(limit).value_or(bound);
    if (shown != shown_limit && (shown < shown_limit) == (number < bound)) break;
  }
}

}  // namespace mjforge::expr
