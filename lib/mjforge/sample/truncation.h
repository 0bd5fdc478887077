// Quantiles of truncated normal and Poisson distributions, and of the beta distribution.

#pragma once

#include "mjforge/sample/distributions.h"

namespace mjforge::sample {

/// Returns true if the standard normal distribution has a representable probability in z. At about
/// 150 standard deviations the probability underflows to 0.
bool NormalReaches(Interval z);
/// Returns the value at u of the standard normal distribution truncated to z. The probability of z
/// is measured from the nearer tail.
double TruncatedNormal(Interval z, double u);

/// NormalReaches and TruncatedNormal for the Poisson distribution. Require mean > 0; limits are any
/// real numbers.
bool PoissonReaches(double mean, Interval limits);
double TruncatedPoisson(double mean, Interval limits, double u);

/// Returns the value at u of the beta distribution on [0, 1].
double BetaQuantile(double a, double b, double u);

}  // namespace mjforge::sample
