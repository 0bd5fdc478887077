// Quantiles of truncated distributions, computed by Boost.Math.

#include "mjforge/sample/truncation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/poisson.hpp>

namespace mjforge::sample {
namespace {

namespace policies = boost::math::policies;

// Policy of Boost.Math: errors give NaN or infinity, which the evaluator reports, instead of
// exceptions. Numbers are not promoted to long double, for speed and for equal results on every
// machine.
using Quiet = policies::policy<
    policies::domain_error<policies::ignore_error>, policies::pole_error<policies::ignore_error>,
    policies::overflow_error<policies::ignore_error>,
    policies::underflow_error<policies::ignore_error>,
    policies::denorm_error<policies::ignore_error>,
    policies::rounding_error<policies::ignore_error>,
    policies::evaluation_error<policies::ignore_error>,
    policies::indeterminate_result_error<policies::ignore_error>,
    policies::discrete_quantile<policies::integer_round_up>, policies::promote_double<false>>;

template <typename Real>
using Normal = boost::math::normal_distribution<Real, Quiet>;
using Poisson = boost::math::poisson_distribution<double, Quiet>;
using Beta = boost::math::beta_distribution<double, Quiet>;

// Probabilities that a random number is below (p) or above (q) the lower end and the upper end of
// an interval.
template <typename Real>
struct Slice {
  Real p_lo, p_hi, q_lo, q_hi;

  // Returns an upper bound of the interval's probability; 0 if the interval is so far in a tail
  // that its probability underflows.
  Real Reach() const { return std::min(p_hi, q_lo); }
};

template <typename Real, typename DistributionType>
double QuantileWithin(const DistributionType& distribution, const Slice<Real>& slice, Real u) {
  const Real p = slice.p_lo + u * (slice.p_hi - slice.p_lo);
  const Real q = slice.q_lo + u * (slice.q_hi - slice.q_lo);
  return static_cast<double>(p < q ? quantile(distribution, p)
                                   : quantile(complement(distribution, q)));
}

template <typename Real>
Slice<Real> NormalSlice(Interval z) {
  const Normal<Real> normal;
  const Real lo = z.lo;
  const Real hi = z.hi;
  return {cdf(normal, lo), cdf(normal, hi), cdf(complement(normal, lo)),
          cdf(complement(normal, hi))};
}

// If the probability of the interval is below this value, doubles lose digits by underflow, and
// long double is used.
constexpr double kSafeReach = 1e-280;

// Returns the smallest interval that contains the same non-negative whole numbers as `limits`.
Interval WholePart(Interval limits) {
  return {std::max(0.0, std::ceil(limits.lo)), std::floor(limits.hi)};
}

Slice<double> PoissonSlice(const Poisson& poisson, Interval whole) {
  Slice<double> slice = {0, 1, 1, 0};
  if (whole.lo > 0) {
    slice.p_lo = cdf(poisson, whole.lo - 1);
    slice.q_lo = cdf(complement(poisson, whole.lo - 1));
  }
  if (std::isfinite(whole.hi)) {
    slice.p_hi = cdf(poisson, whole.hi);
    slice.q_hi = cdf(complement(poisson, whole.hi));
  }
  return slice;
}

}  // namespace

bool NormalReaches(Interval z) { return NormalSlice<long double>(z).Reach() > 0; }

double TruncatedNormal(Interval z, double u) {
  const Slice<double> slice = NormalSlice<double>(z);
  const double value =
      slice.Reach() > kSafeReach
          ? QuantileWithin(Normal<double>(), slice, u)
          : QuantileWithin<long double>(Normal<long double>(), NormalSlice<long double>(z), u);
  return std::clamp(value, z.lo, z.hi);
}

bool PoissonReaches(double mean, Interval limits) {
  const Interval whole = WholePart(limits);
  return whole.lo <= whole.hi && PoissonSlice(Poisson(mean), whole).Reach() > 0;
}

double TruncatedPoisson(double mean, Interval limits, double u) {
  const Poisson poisson(mean);
  const Interval whole = WholePart(limits);
  return std::clamp(QuantileWithin(poisson, PoissonSlice(poisson, whole), u), whole.lo, whole.hi);
}

double BetaQuantile(double a, double b, double u) {
  return std::clamp(quantile(Beta(a, b), u), 0.0, 1.0);
}

}  // namespace mjforge::sample
