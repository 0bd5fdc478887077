// Quantiles, supports and weighted choices at known points.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "mjforge/sample/distributions.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using spec::Distribution;

double At(Distribution distribution, const std::vector<double>& arguments, double u) {
  return Quantile(distribution, arguments, {}, u);
}

TEST_CASE("the distributions stand in the order of their enumeration") {
  const auto all = spec::Distributions();
  for (std::size_t i = 0; i < all.size(); ++i) CHECK(static_cast<std::size_t>(all[i].id) == i);
}

TEST_CASE("uniform is linear between its ends") {
  CHECK(At(Distribution::kUniform, {2, 6}, 0.25) == 3);
  CHECK(At(Distribution::kUniform, {-1e308, 1e308}, 0.5) == 0);
  CHECK(At(Distribution::kUniform, {0.1, 0.1}, 0.7) == 0.1);
}

TEST_CASE("log-uniform is linear in the logarithm") {
  CHECK_THAT(At(Distribution::kLogUniform, {0.01, 100}, 0.75), WithinRel(10, 1e-14));
  CHECK(At(Distribution::kLogUniform, {0.1, 0.1}, 0.7) == 0.1);
}

TEST_CASE("triangular has the mode where its share of u ends") {
  CHECK_THAT(At(Distribution::kTriangular, {1, 2, 4}, 1.0 / 3), WithinRel(2, 1e-14));
  CHECK_THAT(At(Distribution::kTriangular, {1, 2, 4}, 1.0 / 12), WithinRel(1.5, 1e-14));
  CHECK_THAT(At(Distribution::kTriangular, {1, 2, 4}, 5.0 / 6), WithinRel(3, 1e-14));
  CHECK_THAT(At(Distribution::kTriangular, {0, 0, 1}, 0.75), WithinRel(0.5, 1e-14));
  CHECK_THAT(At(Distribution::kTriangular, {0, 1, 1}, 0.25), WithinRel(0.5, 1e-14));
  CHECK(At(Distribution::kTriangular, {0.1, 0.1, 0.1}, 0.7) == 0.1);
}

TEST_CASE("normal and log-normal quantiles agree with the tables") {
  CHECK_THAT(At(Distribution::kNormal, {0, 1}, 0.975), WithinRel(1.959963984540054, 1e-14));
  CHECK_THAT(At(Distribution::kNormal, {0, 1}, 1e-10), WithinRel(-6.361340902404056, 1e-13));
  CHECK_THAT(At(Distribution::kNormal, {5, 2}, 0.025), WithinRel(5 - 2 * 1.959963984540054, 1e-13));
  CHECK_THAT(At(Distribution::kLogNormal, {0.1, 0.5}, 0.975),
             WithinRel(std::exp(0.1 + 0.5 * 1.959963984540054), 1e-14));
  CHECK(At(Distribution::kNormal, {5, 0}, 0.3) == 5);
}

TEST_CASE("exponential quantiles are logarithms") {
  CHECK_THAT(At(Distribution::kExponential, {2}, 0.5), WithinRel(std::log(2.0) / 2, 1e-15));
  CHECK_THAT(At(Distribution::kExponential, {2}, 1e-12), WithinRel(5.0000000000025e-13, 1e-12));
}

TEST_CASE("beta quantiles solve the polynomial of whole shapes") {
  const double x = At(Distribution::kBeta, {2, 3}, 0.4);
  CHECK_THAT(6 * x * x - 8 * x * x * x + 3 * x * x * x * x, WithinRel(0.4, 1e-13));
  CHECK_THAT(At(Distribution::kBeta, {3, 1}, 0.4), WithinRel(std::cbrt(0.4), 1e-14));
  CHECK_THAT(Quantile(Distribution::kBeta, std::vector<double>{2, 3}, Interval{10, 30}, 0.4),
             WithinRel(10 + 20 * x, 1e-14));
}

TEST_CASE("Poisson gives the smallest count whose share reaches u") {
  double share = 0;
  double weight = std::exp(-3.5);
  for (int count = 0; count < 20; ++count) {
    share += weight;
    weight *= 3.5 / (count + 1);
    CHECK(At(Distribution::kPoisson, {3.5}, share - 1e-12) == count);
    CHECK(At(Distribution::kPoisson, {3.5}, share + 1e-12) == count + 1);
  }
  CHECK(At(Distribution::kPoisson, {0}, 0.9) == 0);
}

TEST_CASE("integers have equal shares and both ends") {
  CHECK(At(Distribution::kInteger, {-1, 2}, 0x1p-53) == -1);
  CHECK(At(Distribution::kInteger, {-1, 2}, 0.24) == -1);
  CHECK(At(Distribution::kInteger, {-1, 2}, 0.26) == 0);
  CHECK(At(Distribution::kInteger, {-1, 2}, 0.76) == 2);
  CHECK(At(Distribution::kInteger, {-1, 2}, 1 - 0x1p-53) == 2);
  CHECK(At(Distribution::kInteger, {4, 4}, 0.5) == 4);
}

TEST_CASE("bernoulli is true with its probability") {
  CHECK(At(Distribution::kBernoulli, {0.3}, 0.299) == 1);
  CHECK(At(Distribution::kBernoulli, {0.3}, 0.301) == 0);
  CHECK(At(Distribution::kBernoulli, {0}, 0x1p-53) == 0);
  CHECK(At(Distribution::kBernoulli, {1}, 1 - 0x1p-53) == 1);
}

TEST_CASE("a weighted index has its weight's share of u") {
  const std::vector<double> weights = {1, 0, 2, 1, 0};
  CHECK(WeightedIndex(weights, 0x1p-53) == 0);
  CHECK(WeightedIndex(weights, 0.249) == 0);
  CHECK(WeightedIndex(weights, 0.251) == 2);
  CHECK(WeightedIndex(weights, 0.749) == 2);
  CHECK(WeightedIndex(weights, 0.751) == 3);
  CHECK(WeightedIndex(weights, 1 - 0x1p-53) == 3);
}

TEST_CASE("an option of weight 0 is never taken, whatever the sum's rounding") {
  const std::vector<double> weights = {0, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0};
  CHECK(WeightedIndex(weights, 1 - 0x1p-53) == 10);
  CHECK(WeightedIndex(weights, 0x1p-53) == 1);
}

TEST_CASE("every quantile rises with u and stays in its support") {
  struct Case {
    Distribution distribution;
    std::vector<double> arguments;
    std::optional<Interval> limits;
  };
  const Case cases[] = {
      {Distribution::kUniform, {-1, 3}, {}},
      {Distribution::kLogUniform, {0.5, 3}, {}},
      {Distribution::kTriangular, {-1, 0, 3}, {}},
      {Distribution::kNormal, {1, 2}, {}},
      {Distribution::kNormal, {1, 2}, Interval{2, 8}},
      {Distribution::kLogNormal, {0, 1}, {}},
      {Distribution::kLogNormal, {0, 1}, Interval{-1, 2}},
      {Distribution::kBeta, {0.5, 0.7}, {}},
      {Distribution::kBeta, {2, 5}, Interval{-1, 1}},
      {Distribution::kExponential, {0.5}, {}},
      {Distribution::kExponential, {0.5}, Interval{1, 2}},
      {Distribution::kPoisson, {4}, {}},
      {Distribution::kPoisson, {4}, Interval{2.5, 6.5}},
      {Distribution::kInteger, {-3, 9}, {}},
  };
  for (const Case& one : cases) {
    const Interval support = Support(one.distribution, one.arguments, one.limits);
    double last = -std::numeric_limits<double>::infinity();
    for (int i = 0; i <= 1000; ++i) {
      const double u = std::lerp(0x1p-53, 1 - 0x1p-53, i / 1000.0);
      const double value = Quantile(one.distribution, one.arguments, one.limits, u);
      CAPTURE(static_cast<int>(one.distribution), u);
      REQUIRE(value >= last);
      REQUIRE(value >= support.lo);
      REQUIRE(value <= support.hi);
      last = value;
    }
  }
}

TEST_CASE("a support is as small as it can be") {
  const auto is = [](Interval interval, double lo, double hi) {
    return interval.lo == lo && interval.hi == hi;
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  using Arguments = std::vector<double>;
  CHECK(is(Support(Distribution::kTriangular, Arguments{1, 2, 4}, {}), 1, 4));
  CHECK(is(Support(Distribution::kNormal, Arguments{1, 2}, {}), -kInfinity, kInfinity));
  CHECK(is(Support(Distribution::kNormal, Arguments{1, 0}, {}), 1, 1));
  CHECK(is(Support(Distribution::kLogNormal, Arguments{0, 1}, Interval{-1, 2}), 0, 2));
  CHECK(is(Support(Distribution::kLogNormal, Arguments{0, 0}, {}), 1, 1));
  CHECK(is(Support(Distribution::kBeta, Arguments{1, 2}, {}), 0, 1));
  CHECK(is(Support(Distribution::kExponential, Arguments{1}, {}), 0, kInfinity));
  CHECK(is(Support(Distribution::kPoisson, Arguments{1}, Interval{1.5, 3.5}), 2, 3));
  CHECK(is(Support(Distribution::kPoisson, Arguments{0}, {}), 0, 0));
  CHECK(is(Support(Distribution::kBernoulli, Arguments{0.5}, {}), 0, 1));
  CHECK(is(Support(Distribution::kBernoulli, Arguments{1}, {}), 1, 1));
}

}  // namespace
}  // namespace mjforge::sample
