// Computation of the ticks of chart axes, and choice of the scale.

#include "mjforge/report/axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mjforge::report {
namespace {

// Returns the text of a tick. Rounds to a multiple of the step, so that 3 * 0.1 is shown as 0.3.
std::string Label(double value, double step) {
  const double rounded = std::round(value / step) * step;
  if (std::abs(rounded) < step * 1e-6) return "0";
  // Number of digits that distinguishes neighbouring ticks.
  const double digits = std::ceil(std::log10(std::abs(rounded) / step)) + 1;
  return fmt::format("{:.{}g}", rounded, static_cast<int>(std::clamp(digits, 6.0, 15.0)));
}

}  // namespace

Axis::Axis(Scale scale, double lo, double hi, double start, double end)
    : scale_(scale), lo_(lo), hi_(hi), start_(start), end_(end) {
  if (lo_ < hi_) return;
  const double room = lo == 0 ? 1 : std::abs(lo) * 0.05;
  lo_ = lo - room;
  hi_ = lo + room;
}

double Axis::At(double value) const {
  const double share = scale_ == Scale::kLinear ? (value / 2 - lo_ / 2) / (hi_ / 2 - lo_ / 2)
                                                : std::log(value / lo_) / std::log(hi_ / lo_);
  return start_ + share * (end_ - start_);
}

// Returns the distance between about `count` ticks: 1, 2 or 5 times a power of ten.
double Axis::Step(int count) const {
  const double rough = hi_ / count - lo_ / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  const double digit = rough / power;
  return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
}

std::vector<Axis::Tick> Axis::Ticks(int count) const {
  if (scale_ == Scale::kLogarithmic) return Decades(count);
  const double step = Step(count);
  std::vector<Tick> ticks;
  // Tolerance, because an end that is a multiple of the step except for rounding errors gets a
  // tick.
  const double tolerance = step * 1e-6;
  const double first = std::ceil((lo_ - tolerance) / step);
  for (double i = first; i * step <= hi_ + tolerance; ++i) {
    ticks.push_back({At(i * step), Label(i * step, step)});
  }
  return ticks;
}

std::vector<Axis::Tick> Axis::Decades(int count) const {
  const int first = static_cast<int>(std::floor(std::log10(lo_)));
  const int last = static_cast<int>(std::ceil(std::log10(hi_)));
  const int every = std::max(1, (last - first) / count);
  const bool fine = last - first <= 2;
  constexpr std::array kDigits = {1.0, 2.0, 5.0};
  std::vector<Tick> ticks;
  for (int decade = first; decade <= last; decade += every) {
    for (const double digit : kDigits) {
      const double value = digit * std::pow(10, decade);
      if (value < lo_ * (1 - 1e-9) || value > hi_ * (1 + 1e-9) || (digit > 1 && !fine)) continue;
      ticks.push_back({At(value), fmt::format("{:.4g}", value)});
    }
  }
  return ticks;
}

void Axis::Round(int count) {
  if (scale_ == Scale::kLogarithmic) {
    // Extends the range only by a factor, because whole decades would leave much empty space.
    lo_ /= 1.15;
    hi_ *= 1.15;
    return;
  }
  const double step = Step(count);
  lo_ = std::floor(lo_ / step + 1e-6) * step;
  hi_ = std::ceil(hi_ / step - 1e-6) * step;
}

bool WantsLogarithm(double lo, double hi, double median) {
  return lo > 0 && hi >= 50 * lo && median < 0.2 * hi;
}

std::string ShortNumber(double value) {
  if (value != 0 && std::abs(value) >= 1000 && std::abs(value) < 1e7) {
    return fmt::format("{:.0f}", value);
  }
  return fmt::format("{:.4g}", value == 0 ? 0.0 : value);
}

}  // namespace mjforge::report
