#pragma once

// Normal and Poisson values within an interval: u is mapped into the interval's
// share of probability, measured from the nearer tail.

#include "mjforge/sample/distributions.h"

namespace mjforge::sample {

/// Whether a floating-point number can hold the probability of the standard
/// normal's interval z (some 150 standard deviations out it is gone).
bool NormalReaches(Interval z);
/// Standard normal truncated to z.
double TruncatedNormal(Interval z, double u);

/// As above; mean > 0, any real bounds.
bool PoissonReaches(double mean, Interval limits);
double TruncatedPoisson(double mean, Interval limits, double u);

/// Beta on 0 .. 1.
double BetaQuantile(double a, double b, double u);

}  // namespace mjforge::sample
