#pragma once

// Inverse distribution functions: one uniform number u of (0, 1) in, one value
// out, unrounded. Callers have checked the arguments (CheckArguments).

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "mjforge/spec/spec.h"

namespace mjforge::sample {

/// Above it, not every whole number has a double.
inline constexpr double kMaxWhole = 0x1p53;

/// Closed interval; infinite ends mean "no bound".
struct Interval {
  double lo;
  double hi;
};

/// The interval that the spec states: the ends of a uniform, log-uniform,
/// triangular or integer draw, else the limits.
std::optional<Interval> StatedInterval(spec::Distribution distribution,
                                       std::span<const double> arguments,
                                       std::optional<Interval> limits);

/// What is wrong with the arguments, or nothing: "standard deviation -1 is
/// negative". `limits` is clip (truncation) or, for beta, the range.
std::optional<std::string> CheckArguments(spec::Distribution distribution,
                                          std::span<const double> arguments,
                                          std::optional<Interval> limits);

/// The value at u, for every distribution except choice and cycle. Truncation is exact: u is mapped
/// into [F(lo), F(hi)], through the complement in the upper tail.
double Quantile(spec::Distribution distribution, std::span<const double> arguments,
                std::optional<Interval> limits, double u);

/// The smallest interval that holds every value; for rounding.
Interval Support(spec::Distribution distribution, std::span<const double> arguments,
                 std::optional<Interval> limits);

/// Index i with probability weights[i] / sum; weights are >= 0 with a positive sum.
std::size_t WeightedIndex(std::span<const double> weights, double u);

/// Uniform on SO(3) from three uniforms, w x y z, w >= 0. Source: Shoemake,
/// "Uniform random rotations", Graphics Gems III, 1992.
std::array<double, 4> UniformRotation(double u0, double u1, double u2);

/// Uniform on the unit sphere from two uniforms (Archimedes: z is uniform).
std::array<double, 3> UniformDirection(double u0, double u1);

/// Red, green, blue of hue, saturation, value, all 0 to 1. Source: Smith,
/// "Color gamut transform pairs", SIGGRAPH 1978.
std::array<double, 3> HsvToRgb(double h, double s, double v);

}  // namespace mjforge::sample
