// Tests of the goodness-of-fit tests: a good fit passes, a slightly wrong fit fails.

#include "goodness.h"

#include <catch2/catch.hpp>
#include <cmath>

namespace {

using Catch::Matchers::WithinAbs;

double Identity(double x) { return x; }

std::vector<double> EvenSample(double power) {
  std::vector<double> sample;
  for (int i = 0; i < 20000; ++i) sample.push_back(std::pow((i + 0.5) / 20000, power));
  return sample;
}

TEST_CASE("Kolmogorov-Smirnov accepts an even sample and refuses a bent one") {
  CHECK(KolmogorovSmirnov(EvenSample(1), Identity) == 1);
  CHECK(KolmogorovSmirnov(EvenSample(1.05), Identity) < kLevel);
}

TEST_CASE("Kolmogorov-Smirnov has the critical values of the tables") {
  // For large n the 5 % point of sqrt(n) D is 1.358, the 1 % point 1.628.
  const auto shifted = [](double shift) {
    return KolmogorovSmirnov(EvenSample(1), [shift](double x) { return x + shift; });
  };
  CHECK_THAT(shifted(1.358 / std::sqrt(20000)), WithinAbs(0.05, 2e-3));
  CHECK_THAT(shifted(1.628 / std::sqrt(20000)), WithinAbs(0.01, 5e-4));
}

TEST_CASE("chi-square has the critical values of the tables") {
  // Two classes: 3.841 is the 5 % point of one degree of freedom.
  const double off = std::sqrt(3.841 * 500 / 2);
  const std::vector<double> counts = {500 + off, 500 - off};
  CHECK_THAT(ChiSquare(counts, std::vector<double>{500, 500}), WithinAbs(0.05, 1e-4));
}

TEST_CASE("chi-square joins classes that expect too little") {
  const std::vector<double> counts = {100, 3, 2, 0, 1};
  const std::vector<double> expected = {100, 2.5, 2.5, 0.5, 0.5};
  CHECK(ChiSquare(counts, expected) ==
        ChiSquare(std::vector<double>{100, 6}, std::vector<double>{100, 6}));
}

TEST_CASE("moments and correlation of a known sample") {
  const std::vector<double> a = {1, 2, 3, 4};
  const std::vector<double> b = {4, 3, 2, 1};
  CHECK(MomentsOf(a).mean == 2.5);
  CHECK_THAT(MomentsOf(a).variance, WithinAbs(5.0 / 3, 1e-15));
  CHECK_THAT(Correlation(a, b), WithinAbs(-1, 1e-15));
}

}  // namespace
