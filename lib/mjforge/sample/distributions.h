// Inverse distribution functions (quantiles), checks of their arguments, and uniform rotations,
// directions and colours.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "mjforge/spec/spec.h"

namespace mjforge::sample {

/// Largest number up to which every whole number is exact as a double.
inline constexpr double kMaxWhole = 0x1p53;

/// Closed interval. An infinite end means that there is no bound.
struct Interval {
  double lo;
  double hi;
};

/// Returns the interval that the spec states: the ends of a uniform, log-uniform, triangular or
/// integer draw; for other distributions, `limits`.
std::optional<Interval> StatedInterval(spec::Distribution distribution,
                                       std::span<const double> arguments,
                                       std::optional<Interval> limits);

/// Returns a message about invalid arguments, such as "standard deviation -1 is negative"; nullopt
/// if the arguments are valid. `limits` is the interval of `clip` (truncation) or, for the beta
/// distribution, of `range`.
std::optional<std::string> CheckArguments(spec::Distribution distribution,
                                          std::span<const double> arguments,
                                          std::optional<Interval> limits);

/// Returns the quantile at u, in (0, 1), without rounding; NaN for choice and cycle.
/// CheckArguments() must have accepted the arguments. `limits` are the range of the beta
/// distribution, and truncate all other distributions that have limits. The truncation is exact: u
/// is mapped to the interval [F(lo), F(hi)] of the distribution function F or, in the upper tail,
/// of 1 - F.
double Quantile(spec::Distribution distribution, std::span<const double> arguments,
                std::optional<Interval> limits, double u);

/// Returns the smallest interval that contains every value of the distribution, as the bounds for
/// RoundWithin(). An unbounded distribution has infinite ends; choice and cycle have no bounds.
Interval Support(spec::Distribution distribution, std::span<const double> arguments,
                 std::optional<Interval> limits);

/// Returns the index that u, in (0, 1), selects: index i has the probability weights[i], divided by
/// the sum of the weights. Weights must be >= 0 and their sum positive.
std::size_t WeightedIndex(std::span<const double> weights, double u);

/// Returns a uniformly distributed rotation from three uniform numbers, as a quaternion w x y z
/// with w >= 0. Source: Shoemake, "Uniform random rotations", Graphics Gems III, 1992.
std::array<double, 4> UniformRotation(double u0, double u1, double u2);

/// Returns a uniformly distributed point of the unit sphere from two uniform numbers. The z of the
/// point is uniformly distributed (Archimedes' theorem).
std::array<double, 3> UniformDirection(double u0, double u1);

/// Converts hue, saturation and value to red, green and blue, all in [0, 1]. Source: Smith, "Color
/// gamut transform pairs", SIGGRAPH 1978.
std::array<double, 3> HsvToRgb(double h, double s, double v);

}  // namespace mjforge::sample
