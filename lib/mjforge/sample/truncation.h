// Quantiles of truncated normal and Poisson distributions, and of the beta distribution.

#pragma once

#include "mjforge/sample/distributions.h"

namespace mjforge::sample {

/// Returns true if the probability that a normal variable is in the interval `z` is representable.
/// `z` is in standard deviations from the mean. Beyond about 150 standard deviations, the
/// probability underflows to 0.
bool NormalReaches(Interval z);
/// Returns the quantile at `u` of the standard normal distribution truncated to the interval `z`.
/// Probabilities are computed from the nearer tail.
double TruncatedNormal(Interval z, double u);

/// Counterparts of NormalReaches() and TruncatedNormal() for the Poisson distribution. The mean
/// must be positive; the limits may be any real numbers.
bool PoissonReaches(double mean, Interval limits);
double TruncatedPoisson(double mean, Interval limits, double u);

/// Returns the quantile at u of the beta distribution on [0, 1].
double BetaQuantile(double a, double b, double u);

}  // namespace mjforge::sample
