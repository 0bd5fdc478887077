#pragma once

// How well a sample fits a distribution. With fixed seeds each test gives the
// same probability every time; 0.001 is the level at which it fails.

#include <functional>
#include <span>
#include <vector>

inline constexpr double kLevel = 1e-3;

/// Kolmogorov and Smirnov: the probability of a larger distance between the
/// sample and the continuous distribution `below`. Source: Numerical Recipes,
/// 3rd edition, section 14.3.3 (Stephens' correction for finite samples).
double KolmogorovSmirnov(std::vector<double> sample, const std::function<double(double)>& below);

/// Pearson's chi-square: the probability of a larger deviation of the counts
/// from those expected. Classes that expect fewer than 5 join the next one.
double ChiSquare(std::span<const double> counts, std::span<const double> expected);

struct Moments {
  double mean;
  double variance;
};
Moments MomentsOf(std::span<const double> sample);

/// Pearson's correlation of two samples of one size.
double Correlation(std::span<const double> a, std::span<const double> b);
