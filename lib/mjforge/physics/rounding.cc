#include "mjforge/physics/rounding.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"

namespace mjforge::physics {
namespace {

constexpr double kMostWritten = 1e9;  // longer numbers are read as powers of ten

std::string WithDigits(double value, int digits) {
  std::string text = fmt::format("{:.{}g}", value, digits);
  if (text.find("e+") == text.npos || std::abs(value) >= kMostWritten) return text;
  return fmt::format("{:.0f}", value);
}

}  // namespace

std::string RoundedText(double value) { return WithDigits(value, 3); }

std::string SpeedText(double speed) {
  return speed < 1 ? RoundedText(1000 * speed) + " mm/s" : RoundedText(speed) + " m/s";
}

std::string DistanceText(bool is_slide, double distance) {
  return is_slide ? RoundedText(1000 * distance) + " mm"
                  : RoundedText(distance * 180 / std::numbers::pi) + " deg";
}

Beyond::Beyond(double number, double bound) {
  for (int digits = 3; digits <= 17; ++digits) {
    value = WithDigits(number, digits);
    limit = WithDigits(bound, digits);
    const double shown = expr::ParseNumber(value).value_or(number);
    const double shown_limit = expr::ParseNumber(limit).value_or(bound);
    if (shown != shown_limit && (shown < shown_limit) == (number < bound)) break;
  }
}

}  // namespace mjforge::physics
