// Goodness-of-fit tests, moments and correlation. Seeds are fixed, so that each test computes the
// same probability every time; a test fails at the level of 0.001.

#pragma once

#include <functional>
#include <span>
#include <vector>

inline constexpr double kLevel = 1e-3;

/// Kolmogorov-Smirnov test: returns the probability of a larger distance between a sample and the
/// continuous distribution function `below`. Source: Numerical Recipes, 3rd edition, section 14.3.3
/// (Stephens' correction for finite samples).
double KolmogorovSmirnov(std::vector<double> sample, const std::function<double(double)>& below);

/// Pearson's chi-square test: returns the probability of a larger deviation of the counts from the
/// expected counts. A class with an expected count below 5 is joined with the next class.
double ChiSquare(std::span<const double> counts, std::span<const double> expected);

struct Moments {
  double mean;
  double variance;
};
Moments MomentsOf(std::span<const double> sample);

/// Returns Pearson's correlation of two samples of equal size.
double Correlation(std::span<const double> a, std::span<const double> b);
