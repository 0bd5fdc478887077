// Checks of the arguments and limits of a draw from a distribution.

#include <cmath>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/sample/distributions.h"
#include "mjforge/sample/truncation.h"

namespace mjforge::sample {
namespace {

using expr::NumberText;
using spec::Distribution;
using Message = std::optional<std::string>;

// Maximum mean of a Poisson draw: larger than any useful count. The limit bounds the time that
// Boost.Math needs to find a quantile.
constexpr double kMaxPoissonMean = 1e6;

Message CheckNotNegative(std::string_view what, double value) {
  if (value >= 0) return std::nullopt;
  return fmt::format("{} {} is negative", what, NumberText(value));
}

Message CheckPositive(std::string_view what, double value) {
  if (value > 0) return std::nullopt;
  return fmt::format("{} {} is not greater than 0", what, NumberText(value));
}

Message CheckInteger(std::span<const double> ends) {
  for (const double end : ends) {
    if (end != std::floor(end)) {
      return fmt::format("end {} of the integer range is not a whole number", NumberText(end));
    }
    if (std::abs(end) > kMaxWhole) {
      return fmt::format("end {} of the integer range is beyond 2^53", NumberText(end));
    }
  }
  return std::nullopt;
}

Message CheckTriangular(double lo, double mode, double hi) {
  if (lo <= mode && mode <= hi) return std::nullopt;
  return fmt::format("mode {} is outside the range {} .. {}", NumberText(mode), NumberText(lo),
                     NumberText(hi));
}

bool NormalCanGive(double mean, double deviation, Interval limits) {
  if (deviation == 0) return limits.lo <= mean && mean <= limits.hi;
  return NormalReaches({(limits.lo - mean) / deviation, (limits.hi - mean) / deviation});
}

bool CanGive(Distribution distribution, std::span<const double> a, Interval limits) {
  switch (distribution) {
    case Distribution::kNormal:
      return NormalCanGive(a[0], a[1], limits);
    case Distribution::kLogNormal: {
      const double lo = limits.lo > 0 ? std::log(limits.lo) : -HUGE_VAL;
      return limits.hi > 0 && NormalCanGive(a[0], a[1], {lo, std::log(limits.hi)});
    }
    case Distribution::kExponential:
      return limits.hi >= 0;
    case Distribution::kPoisson:
      return a[0] == 0 ? limits.lo <= 0 && 0 <= limits.hi : PoissonReaches(a[0], limits);
    default:
      return true;
  }
}

Message CheckOwnArguments(Distribution distribution, std::span<const double> a) {
  switch (distribution) {
    case Distribution::kLogUniform:
      return CheckPositive("lower end", a[0]);
    case Distribution::kTriangular:
      return CheckTriangular(a[0], a[1], a[2]);
    case Distribution::kNormal:
      return CheckNotNegative("standard deviation", a[1]);
    case Distribution::kLogNormal:
      return CheckNotNegative("sigma", a[1]);
    case Distribution::kBeta: {
      const Message first = CheckPositive("first shape", a[0]);
      return first ? first : CheckPositive("second shape", a[1]);
    }
    case Distribution::kExponential:
      return CheckPositive("rate", a[0]);
    case Distribution::kPoisson:
      if (a[0] > kMaxPoissonMean) {
        return fmt::format("mean {} is above {}", NumberText(a[0]), NumberText(kMaxPoissonMean));
      }
      return CheckNotNegative("mean", a[0]);
    case Distribution::kInteger:
      return CheckInteger(a);
    case Distribution::kBernoulli:
      if (a[0] >= 0 && a[0] <= 1) return std::nullopt;
      return fmt::format("probability {} is not between 0 and 1", NumberText(a[0]));
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<Interval> StatedInterval(Distribution distribution, std::span<const double> arguments,
                                       std::optional<Interval> limits) {
  switch (distribution) {
    case Distribution::kUniform:
    case Distribution::kLogUniform:
    case Distribution::kInteger:
    case Distribution::kTriangular:
      return Interval{arguments.front(), arguments.back()};
    default:
      return limits;
  }
}

std::optional<std::string> CheckArguments(Distribution distribution,
                                          std::span<const double> arguments,
                                          std::optional<Interval> limits) {
  if (const auto stated = StatedInterval(distribution, arguments, limits);
      stated && stated->lo > stated->hi) {
    return fmt::format("{} {} .. {} is empty: its lower end is above its upper end",
                       limits && distribution != Distribution::kBeta ? "clip" : "range",
                       NumberText(stated->lo), NumberText(stated->hi));
  }
  if (Message message = CheckOwnArguments(distribution, arguments)) return message;
  if (limits && !CanGive(distribution, arguments, *limits)) {
    return fmt::format("clip {} .. {} leaves no possible value", NumberText(limits->lo),
                       NumberText(limits->hi));
  }
  return std::nullopt;
}

}  // namespace mjforge::sample
