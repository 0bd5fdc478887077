// Quantile functions and supports of the distributions, and the choice of an index by weights.

#include "mjforge/sample/distributions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "mjforge/sample/truncation.h"

namespace mjforge::sample {
namespace {

using spec::Distribution;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Interval kEverything = {-kInfinity, kInfinity};

double LogUniform(double lo, double hi, double u) {
  return std::clamp(std::exp(std::lerp(std::log(lo), std::log(hi), u)), lo, hi);
}

double Triangular(double lo, double mode, double hi, double u) {
  const double width = hi - lo;
  if (width == 0) return lo;
  // Takes two separate roots, because the product of two small widths may underflow.
  if (u * width < mode - lo) return lo + std::sqrt(u * width) * std::sqrt(mode - lo);
  return hi - std::sqrt((1 - u) * width) * std::sqrt(hi - mode);
}

double NormalValue(double mean, double deviation, Interval limits, double u) {
  if (deviation == 0) return mean;
  if (limits.lo == limits.hi) return limits.lo;
  const Interval z = {(limits.lo - mean) / deviation, (limits.hi - mean) / deviation};
  return std::clamp(mean + deviation * TruncatedNormal(z, u), limits.lo, limits.hi);
}

double LogNormal(double mu, double sigma, Interval limits, double u) {
  if (limits.lo == limits.hi) return limits.lo;
  const Interval logs = {limits.lo > 0 ? std::log(limits.lo) : -kInfinity, std::log(limits.hi)};
  return std::clamp(std::exp(NormalValue(mu, sigma, logs, u)), limits.lo, limits.hi);
}

// Returns the quantile at `u` of a truncated exponential distribution. The distribution is
// memoryless: its part above lo is the same distribution, shifted by lo.
double Exponential(double rate, Interval limits, double u) {
  const double lo = std::max(0.0, limits.lo);
  const double value = lo - std::log1p(u * std::expm1(-rate * (limits.hi - lo))) / rate;
  return std::clamp(value, lo, limits.hi);
}

}  // namespace

double Quantile(Distribution distribution, std::span<const double> arguments,
                std::optional<Interval> limits, double u) {
  const auto& a = arguments;
  const Interval within = limits.value_or(kEverything);
  switch (distribution) {
    case Distribution::kUniform:
      return std::lerp(a[0], a[1], u);
    case Distribution::kLogUniform:
      return LogUniform(a[0], a[1], u);
    case Distribution::kTriangular:
      return Triangular(a[0], a[1], a[2], u);
    case Distribution::kNormal:
      return NormalValue(a[0], a[1], within, u);
    case Distribution::kLogNormal:
      return LogNormal(a[0], a[1], within, u);
    case Distribution::kBeta: {
      const Interval range = limits.value_or(Interval{0, 1});
      return std::lerp(range.lo, range.hi, BetaQuantile(a[0], a[1], u));
    }
    case Distribution::kExponential:
      return Exponential(a[0], within, u);
    case Distribution::kPoisson:
      return a[0] == 0 ? 0 : TruncatedPoisson(a[0], within, u);
    case Distribution::kInteger:
      return std::min(a[0] + std::floor(u * (a[1] - a[0] + 1)), a[1]);
    case Distribution::kBernoulli:
      return u < a[0] ? 1 : 0;
    case Distribution::kChoice:
    case Distribution::kCycle:
      break;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

Interval Support(Distribution distribution, std::span<const double> arguments,
                 std::optional<Interval> limits) {
  const auto& a = arguments;
  const Interval within = limits.value_or(kEverything);
  const Interval positive = {std::max(0.0, within.lo), within.hi};
  switch (distribution) {
    case Distribution::kUniform:
    case Distribution::kLogUniform:
    case Distribution::kInteger:
    case Distribution::kTriangular:
      return {a.front(), a.back()};
    case Distribution::kNormal:
      return a[1] == 0 ? Interval{a[0], a[0]} : within;
    case Distribution::kLogNormal:
      return a[1] == 0 ? Interval{std::exp(a[0]), std::exp(a[0])} : positive;
    case Distribution::kBeta:
      return limits.value_or(Interval{0, 1});
    case Distribution::kExponential:
      return positive;
    case Distribution::kPoisson:
      if (a[0] == 0) return {0, 0};
      return {std::ceil(positive.lo), std::floor(positive.hi)};
    case Distribution::kBernoulli:
      return {a[0] < 1 ? 0.0 : 1.0, a[0] > 0 ? 1.0 : 0.0};
    case Distribution::kChoice:
    case Distribution::kCycle:
      break;
  }
  return kEverything;
}

std::size_t WeightedIndex(std::span<const double> weights, double u) {
  const double target = u * std::accumulate(weights.begin(), weights.end(), 0.0);
  double below = 0;
  std::size_t last = 0;  // last index of a positive weight, if rounding makes `below` too small
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] == 0) continue;
    last = i;
    below += weights[i];
    if (target < below) break;
  }
  return last;
}

}  // namespace mjforge::sample
