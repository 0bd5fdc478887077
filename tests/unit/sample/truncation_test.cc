// Quantiles of truncated distributions, far tails included.

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "mjforge/sample/distributions.h"

namespace mjforge::sample {
namespace {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using spec::Distribution;

const double kUniforms[] = {1e-9, 0.01, 0.3, 0.5, 0.7, 0.99, 1 - 1e-9};

// Returns the probability that a standard normal number is above z. Accurate up to z = 150 if the
// exponent of long double has 15 bits.
long double Above(double z) { return std::erfc(z / std::sqrt(2.0L)) / 2; }

// Returns the probability of numbers below `value` in the standard normal distribution truncated to
// `z`. Accurate in the upper tail.
double FractionBelow(double value, Interval z) {
  return static_cast<double>((Above(z.lo) - Above(value)) / (Above(z.lo) - Above(z.hi)));
}

TEST_CASE("a normal clipped far out is exact within its clip") {
  const std::vector<double> standard = {0, 1};
  for (const Interval z : {Interval{5, 6}, Interval{-1, 2}, Interval{20, 21}, Interval{37, 38},
                           Interval{39, 40}, Interval{-1, 40}}) {
    for (const double u : kUniforms) {
      const double value = Quantile(Distribution::kNormal, standard, z, u);
      REQUIRE(z.lo <= value);
      REQUIRE(value <= z.hi);
      // A relative error of 1e-15 in a value near 39 is 39^2 times as large in its tail
      // probability.
      CHECK_THAT(FractionBelow(value, z), WithinAbs(u, 1e-11));
      const double mirrored =
          Quantile(Distribution::kNormal, standard, Interval{-z.hi, -z.lo}, 1 - u);
      CHECK_THAT(mirrored, WithinRel(-value, 1e-7));
    }
  }
}

TEST_CASE("a clip counts from the mean in standard deviations") {
  const std::vector<double> arguments = {10, 0.5};
  const std::vector<double> standard = {0, 1};
  for (const double u : kUniforms) {
    CHECK_THAT(
        Quantile(Distribution::kNormal, arguments, Interval{9, 10.5}, u),
        WithinRel(10 + 0.5 * Quantile(Distribution::kNormal, standard, Interval{-2, 1}, u), 1e-14));
  }
}

TEST_CASE("a clipped log-normal is the exponential of a clipped normal") {
  const std::vector<double> arguments = {0.5, 0.25};
  const Interval limits = {1, 2};
  const Interval logs = {0, std::log(2.0)};
  for (const double u : kUniforms) {
    CHECK_THAT(Quantile(Distribution::kLogNormal, arguments, limits, u),
               WithinRel(std::exp(Quantile(Distribution::kNormal, arguments, logs, u)), 1e-14));
  }
  CHECK(Quantile(Distribution::kLogNormal, arguments, Interval{-5, 1.5}, 1e-6) > 0);
}

TEST_CASE("a clipped exponential begins again at its lower limit") {
  const std::vector<double> rate = {2};
  for (const double u : kUniforms) {
    const double near = Quantile(Distribution::kExponential, rate, Interval{0, 1}, u);
    CHECK_THAT(Quantile(Distribution::kExponential, rate, Interval{5000, 5001}, u),
               WithinAbs(5000 + near, 1e-11));
    CHECK_THAT(-std::expm1(-2 * near), WithinRel(u * -std::expm1(-2.0), 1e-9));
  }
  CHECK(Quantile(Distribution::kExponential, rate, Interval{-3, 1}, 1e-9) >= 0);
}

TEST_CASE("a clipped Poisson draw has the weights of its whole numbers") {
  const std::vector<double> mean = {3.5};
  // P(2), P(3), P(4) are in proportion 1 : 3.5/3 : 3.5^2/12.
  const double sum = 1 + 3.5 / 3 + 3.5 * 3.5 / 12;
  const Interval limits = {1.2, 4.9};
  CHECK(Quantile(Distribution::kPoisson, mean, limits, 1e-9) == 2);
  CHECK(Quantile(Distribution::kPoisson, mean, limits, 1 / sum - 1e-9) == 2);
  CHECK(Quantile(Distribution::kPoisson, mean, limits, 1 / sum + 1e-9) == 3);
  CHECK(Quantile(Distribution::kPoisson, mean, limits, (1 + 3.5 / 3) / sum - 1e-9) == 3);
  CHECK(Quantile(Distribution::kPoisson, mean, limits, (1 + 3.5 / 3) / sum + 1e-9) == 4);
  CHECK(Quantile(Distribution::kPoisson, mean, limits, 1 - 1e-9) == 4);
}

TEST_CASE("a Poisson draw clipped to the upper tail has the weights of that tail") {
  const std::vector<double> mean = {3.5};
  // P(40), P(41) are in proportion 1 : 3.5/41.
  const double share = 1 / (1 + 3.5 / 41);
  CHECK(Quantile(Distribution::kPoisson, mean, Interval{40, 41}, share - 1e-9) == 40);
  CHECK(Quantile(Distribution::kPoisson, mean, Interval{40, 41}, share + 1e-9) == 41);
}

TEST_CASE("a clip of one number gives that number") {
  CHECK(Quantile(Distribution::kNormal, std::vector<double>{0, 1}, Interval{0.7, 0.7}, 0.3) == 0.7);
  CHECK(Quantile(Distribution::kLogNormal, std::vector<double>{0, 1}, Interval{0.7, 0.7}, 0.3) ==
        0.7);
  CHECK(Quantile(Distribution::kExponential, std::vector<double>{1}, Interval{0.7, 0.7}, 0.3) ==
        0.7);
  CHECK(Quantile(Distribution::kPoisson, std::vector<double>{1}, Interval{7, 7}, 0.3) == 7);
}

}  // namespace
}  // namespace mjforge::sample
