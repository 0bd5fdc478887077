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

/// Above this limit not every whole number is a double.
inline constexpr double kMaxWhole = 0x1p53;

/// Closed interval; infinite ends mean "no bound".
struct Interval {
  double lo;
  double hi;
};

/// Returns the interval that the spec gives: the ends of a uniform, log-uniform, triangular or
/// integer draw, else the limits.
std::optional<Interval> StatedInterval(spec::Distribution distribution,
                                       std::span<const double> arguments,
                                       std::optional<Interval> limits);

/// Returns a message about invalid arguments, such as "standard deviation -1 is negative", or
/// nullopt if the arguments are valid. `limits` is the clip (truncation) or, for beta, the range.
std::optional<std::string> CheckArguments(spec::Distribution distribution,
                                          std::span<const double> arguments,
                                          std::optional<Interval> limits);

/// Returns the value at u in (0, 1), not rounded, for every distribution except choice and cycle.
/// CheckArguments() must have accepted the arguments. Truncation is exact: u is mapped into
/// [F(lo), F(hi)], through the complement in the upper tail.
double Quantile(spec::Distribution distribution, std::span<const double> arguments,
                std::optional<Interval> limits, double u);

/// Returns the smallest interval that contains every value. Rounding uses it.
Interval Support(spec::Distribution distribution, std::span<const double> arguments,
                 std::optional<Interval> limits);

/// Returns index i with probability weights[i] / sum. Weights are >= 0 with a positive sum.
std::size_t WeightedIndex(std::span<const double> weights, double u);

/// Returns a uniform rotation from three uniforms, as a quaternion w x y z with w >= 0. Source:
/// Shoemake, "Uniform random rotations", Graphics Gems III, 1992.
std::array<double, 4> UniformRotation(double u0, double u1, double u2);

/// Returns a uniform point of the unit sphere from two uniforms (Archimedes: z is uniform).
std::array<double, 3> UniformDirection(double u0, double u1);

/// Converts hue, saturation, value to red, green, blue; all are in [0, 1]. Source: Smith, "Color
/// gamut transform pairs", SIGGRAPH 1978.
std::array<double, 3> HsvToRgb(double h, double s, double v);

}  // namespace mjforge::sample
