// Tests of distributions: bounds, mean, variance and shape of 20,000 draws each, against expected
// values from textbooks.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "goodness.h"
#include "mjforge/sample/distributions.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using Catch::Matchers::WithinAbs;
using spec::Distribution;

constexpr int kDraws = 20000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Draws by the rules of the evaluator: one uniform number, its quantile, rounding of reals.
std::vector<double> Drawn(Distribution distribution, const std::vector<double>& arguments,
                          std::optional<Interval> limits, bool rounded) {
  const StreamId stream = Child(Child(kRootStream, "stats"), "p");
  const Interval support = Support(distribution, arguments, limits);
  std::vector<double> sample;
  for (std::uint64_t index = 0; index < kDraws; ++index) {
    const double u = Uniforms({.seed = 11, .index = index}, stream)[0];
    const double value = Quantile(distribution, arguments, limits, u);
    sample.push_back(rounded ? RoundWithin(support.lo, support.hi, value) : value);
  }
  return sample;
}

// Allows five standard errors. The standard error of the mean is sqrt(variance / n); that of the
// variance is estimated from the sample's fourth moment.
void CheckMoments(const std::vector<double>& sample, double mean, double variance) {
  const double n = static_cast<double>(sample.size());
  const Moments moments = MomentsOf(sample);
  double fourth = 0;
  for (const double value : sample) fourth += std::pow(value - moments.mean, 4) / n;
  CHECK_THAT(moments.mean, WithinAbs(mean, 5 * std::sqrt(variance / n)));
  const double error = std::sqrt(std::max(0.0, fourth - variance * variance) / n);
  CHECK_THAT(moments.variance, WithinAbs(variance, 5 * error));
}

void CheckBounds(const std::vector<double>& sample, double lo, double hi) {
  CHECK(*std::ranges::min_element(sample) >= lo);
  CHECK(*std::ranges::max_element(sample) <= hi);
}

double NormalBelow(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }
double NormalDensity(double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::acos(-1.0)); }

TEST_CASE("uniform draws are uniform") {
  const auto sample = Drawn(Distribution::kUniform, {-1, 3}, {}, true);
  CheckBounds(sample, -1, 3);
  CheckMoments(sample, 1, 16.0 / 12);
  CHECK(KolmogorovSmirnov(sample, [](double x) { return (x + 1) / 4; }) > kLevel);
}

TEST_CASE("log-uniform draws are uniform in the logarithm") {
  const auto sample = Drawn(Distribution::kLogUniform, {0.01, 10}, {}, true);
  const double ratio = std::log(1000.0);
  const double mean = 9.99 / ratio;
  CheckBounds(sample, 0.01, 10);
  CheckMoments(sample, mean, (100 - 1e-4) / (2 * ratio) - mean * mean);
  CHECK(KolmogorovSmirnov(sample, [&](double x) { return std::log(x / 0.01) / ratio; }) > kLevel);
}

TEST_CASE("triangular draws rise to the mode and fall") {
  const auto sample = Drawn(Distribution::kTriangular, {1, 2, 4}, {}, true);
  CheckBounds(sample, 1, 4);
  CheckMoments(sample, 7.0 / 3, (1 + 4 + 16 - 2 - 4 - 8) / 18.0);
  CHECK(KolmogorovSmirnov(sample, [](double x) {
          return x < 2 ? (x - 1) * (x - 1) / 3 : 1 - (4 - x) * (4 - x) / 6;
        }) > kLevel);
}

TEST_CASE("normal draws are normal") {
  const auto sample = Drawn(Distribution::kNormal, {5, 2}, {}, true);
  CheckMoments(sample, 5, 4);
  CHECK(KolmogorovSmirnov(sample, [](double x) { return NormalBelow((x - 5) / 2); }) > kLevel);
}

TEST_CASE("clipped normal draws are normal between their limits") {
  const auto sample = Drawn(Distribution::kNormal, {5, 2}, Interval{4, 8}, true);
  const double a = -0.5;
  const double b = 1.5;
  const double share = NormalBelow(b) - NormalBelow(a);
  const double shift = (NormalDensity(a) - NormalDensity(b)) / share;
  const double slope = (a * NormalDensity(a) - b * NormalDensity(b)) / share;
  CheckBounds(sample, 4, 8);
  CheckMoments(sample, 5 + 2 * shift, 4 * (1 + slope - shift * shift));
  CHECK(KolmogorovSmirnov(sample, [&](double x) {
          return (NormalBelow((x - 5) / 2) - NormalBelow(a)) / share;
        }) > kLevel);
}

TEST_CASE("normal draws clipped to a far tail have that tail's shape") {
  for (const Interval z : {Interval{5, 6}, Interval{-40, -39}}) {
    const auto sample = Drawn(Distribution::kNormal, {0, 1}, z, true);
    CheckBounds(sample, z.lo, z.hi);
    const auto above = [](double x) { return std::erfc(std::abs(x) / std::sqrt(2.0L)); };
    const long double nearer = above(z.lo > 0 ? z.lo : z.hi);
    const long double share = nearer - above(z.lo > 0 ? z.hi : z.lo);
    CHECK(KolmogorovSmirnov(sample, [&](double x) {
            const auto outwards = static_cast<double>((nearer - above(x)) / share);
            return z.lo > 0 ? outwards : 1 - outwards;
          }) > kLevel);
  }
}

TEST_CASE("log-normal draws are normal in the logarithm") {
  const auto sample = Drawn(Distribution::kLogNormal, {0.2, 0.4}, {}, true);
  const double mean = std::exp(0.2 + 0.08);
  CheckBounds(sample, 0, kInfinity);
  CheckMoments(sample, mean, mean * mean * std::expm1(0.16));
  CHECK(KolmogorovSmirnov(sample, [](double x) { return NormalBelow((std::log(x) - 0.2) / 0.4); }) >
        kLevel);
}

TEST_CASE("clipped log-normal draws keep their shape between the limits") {
  const auto sample = Drawn(Distribution::kLogNormal, {0, 0.5}, Interval{0.5, 2}, true);
  const auto below = [](double x) { return NormalBelow(std::log(x) / 0.5); };
  const double share = below(2) - below(0.5);
  const auto partial = [&](double k) {  // k-th moment
    const double a = (std::log(0.5) - k * 0.25) / 0.5;
    const double b = (std::log(2.0) - k * 0.25) / 0.5;
    return std::exp(k * k * 0.125) * (NormalBelow(b) - NormalBelow(a)) / share;
  };
  CheckBounds(sample, 0.5, 2);
  CheckMoments(sample, partial(1), partial(2) - partial(1) * partial(1));
  CHECK(KolmogorovSmirnov(sample, [&](double x) { return (below(x) - below(0.5)) / share; }) >
        kLevel);
}

TEST_CASE("beta draws have the beta shape over their range") {
  const auto below = [](double x) { return x * x * (6 - 8 * x + 3 * x * x); };  // a = 2, b = 3
  const auto sample = Drawn(Distribution::kBeta, {2, 3}, {}, true);
  CheckBounds(sample, 0, 1);
  CheckMoments(sample, 0.4, 6.0 / (25 * 6));
  CHECK(KolmogorovSmirnov(sample, below) > kLevel);
  const auto scaled = Drawn(Distribution::kBeta, {2, 3}, Interval{-10, 10}, true);
  CheckBounds(scaled, -10, 10);
  CheckMoments(scaled, -2, 16);
  CHECK(KolmogorovSmirnov(scaled, [&](double x) { return below((x + 10) / 20); }) > kLevel);
}

TEST_CASE("beta draws with both shapes below 1 crowd at the ends") {
  const auto sample = Drawn(Distribution::kBeta, {0.5, 0.5}, {}, true);  // the arcsine law
  CheckBounds(sample, 0, 1);
  CheckMoments(sample, 0.5, 0.125);
  CHECK(KolmogorovSmirnov(sample, [](double x) {
          return 2 / std::acos(-1.0) * std::asin(std::sqrt(x));
        }) > kLevel);
}

TEST_CASE("exponential draws are exponential") {
  const auto sample = Drawn(Distribution::kExponential, {4}, {}, true);
  CheckBounds(sample, 0, kInfinity);
  CheckMoments(sample, 0.25, 0.0625);
  CHECK(KolmogorovSmirnov(sample, [](double x) { return -std::expm1(-4 * x); }) > kLevel);
}

TEST_CASE("clipped exponential draws keep their shape between the limits") {
  const auto sample = Drawn(Distribution::kExponential, {1}, Interval{2, 3}, true);
  const double share =
      -std::expm1(-1);  // probability of 2 .. 3 for an exponential that begins at 2
  const double mean = 1 - std::exp(-1) / share;
  CheckBounds(sample, 2, 3);
  CheckMoments(sample, 2 + mean, (2 - 5 * std::exp(-1)) / share - mean * mean);
  CHECK(KolmogorovSmirnov(sample, [&](double x) { return -std::expm1(2 - x) / share; }) > kLevel);
}

// Returns the p-value of the chi-square test of whole numbers lo, lo + 1, ... with these weights.
double FitOfWhole(const std::vector<double>& sample, int lo, std::vector<double> weights) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  std::vector<double> counts(weights.size());
  for (const double value : sample) {
    REQUIRE(value == std::floor(value));
    counts.at(static_cast<std::size_t>(static_cast<int>(value) - lo)) += 1;
  }
  for (double& weight : weights) weight *= kDraws / sum;
  return ChiSquare(counts, weights);
}

std::vector<double> PoissonWeights(double mean, int lo, int hi) {
  std::vector<double> weights;
  for (int count = lo; count <= hi; ++count) {
    weights.push_back(std::exp(count * std::log(mean) - mean - std::lgamma(count + 1.0)));
  }
  return weights;
}

TEST_CASE("Poisson draws have the Poisson weights") {
  const auto sample = Drawn(Distribution::kPoisson, {3.5}, {}, false);
  CheckBounds(sample, 0, 40);
  CheckMoments(sample, 3.5, 3.5);
  CHECK(FitOfWhole(sample, 0, PoissonWeights(3.5, 0, 40)) > kLevel);
  const auto large = Drawn(Distribution::kPoisson, {400}, {}, false);
  CheckMoments(large, 400, 400);
  CHECK(FitOfWhole(large, 250, PoissonWeights(400, 250, 550)) > kLevel);
}

TEST_CASE("clipped Poisson draws have the Poisson weights between the limits") {
  const auto sample = Drawn(Distribution::kPoisson, {3.5}, Interval{2, 6}, false);
  const auto weights = PoissonWeights(3.5, 2, 6);
  double sum = 0;
  double mean = 0;
  double square = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double count = static_cast<double>(i) + 2;
    sum += weights[i];
    mean += weights[i] * count;
    square += weights[i] * count * count;
  }
  mean /= sum;
  CheckBounds(sample, 2, 6);
  CheckMoments(sample, mean, square / sum - mean * mean);
  CHECK(FitOfWhole(sample, 2, weights) > kLevel);
}

TEST_CASE("integers are equally frequent, both ends included") {
  const auto sample = Drawn(Distribution::kInteger, {-3, 3}, {}, false);
  CheckBounds(sample, -3, 3);
  CheckMoments(sample, 0, 4);
  CHECK(FitOfWhole(sample, -3, std::vector<double>(7, 1)) > kLevel);
}

TEST_CASE("bernoulli draws are true as often as their probability says") {
  const auto sample = Drawn(Distribution::kBernoulli, {0.3}, {}, false);
  CheckBounds(sample, 0, 1);
  CheckMoments(sample, 0.3, 0.21);
  CHECK(FitOfWhole(sample, 0, {0.7, 0.3}) > kLevel);
}

TEST_CASE("weighted choices have their weights' shares") {
  const std::vector<double> weights = {3, 0, 1, 0.5, 5};
  std::vector<double> counts(weights.size());
  for (std::uint64_t index = 0; index < kDraws; ++index) {
    counts[WeightedIndex(weights, Uniforms({.seed = 11, .index = index}, 8)[0])] += 1;
  }
  CHECK(counts[1] == 0);
  const std::vector<double> shares = {3, 1, 0.5, 5};
  std::vector<double> expected;
  for (const double share : shares) expected.push_back(kDraws * share / 9.5);
  const std::vector<double> positive = {counts[0], counts[2], counts[3], counts[4]};
  CHECK(ChiSquare(positive, expected) > kLevel);
  // Mean and variance of the index.
  CHECK_THAT((2 * counts[2] + 3 * counts[3] + 4 * counts[4]) / kDraws,
             WithinAbs(23.5 / 9.5, 5 * std::sqrt(3.04 / kDraws)));
}

}  // namespace
}  // namespace mjforge::sample
