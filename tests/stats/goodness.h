// Goodness-of-fit tests of samples, and sample moments.

#pragma once

#include <functional>
#include <span>
#include <vector>

/// Significance level of the tests. Because seeds are fixed, a test has the same result every time.
inline constexpr double kLevel = 1e-3;

/// Returns the p-value of the Kolmogorov-Smirnov test of a sample against the continuous cumulative
/// distribution function `below`. Source: Numerical Recipes, 3rd edition, section 14.3.3 (Stephens'
/// correction for finite samples).
double KolmogorovSmirnov(std::vector<double> sample, const std::function<double(double)>& below);

/// Returns the p-value of Pearson's chi-square test. A class with an expected count below 5 is
/// merged with the next class.
double ChiSquare(std::span<const double> counts, std::span<const double> expected);

struct Moments {
  double mean;
  double variance;
};
Moments MomentsOf(std::span<const double> sample);

/// Returns Pearson's correlation of two samples of equal size.
double Correlation(std::span<const double> a, std::span<const double> b);
