// Tests that draws of neighbouring seeds, indices, attempts and streams are independent.

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "goodness.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

constexpr std::uint64_t kPairs = 20000;
// Allows five standard errors of the correlation of independent samples.
const double kNoCorrelation = 5 / std::sqrt(static_cast<double>(kPairs));

// Checks that pairs are uncorrelated and uniform over a 10 x 10 board.
void CheckIndependent(const std::vector<double>& a, const std::vector<double>& b) {
  CHECK(std::abs(Correlation(a, b)) < kNoCorrelation);
  std::vector<double> counts(100);
  for (std::size_t i = 0; i < a.size(); ++i) {
    counts[static_cast<std::size_t>(a[i] * 10) * 10 + static_cast<std::size_t>(b[i] * 10)] += 1;
  }
  const std::vector<double> expected(100, static_cast<double>(kPairs) / 100);
  CHECK(ChiSquare(counts, expected) > kLevel);
}

template <typename First, typename Second>
void CheckPairs(First first, Second second) {
  std::vector<double> a;
  std::vector<double> b;
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    a.push_back(first(i));
    b.push_back(second(i));
  }
  CheckIndependent(a, b);
}

double Uniform(DrawKey key, StreamId stream, std::size_t word = 0) {
  return Uniforms(key, stream)[word];
}

TEST_CASE("neighbouring variants are independent") {
  CheckPairs([](std::uint64_t i) { return Uniform({.index = i}, 5); },
             [](std::uint64_t i) { return Uniform({.index = i + 1}, 5); });
}

TEST_CASE("neighbouring seeds are independent") {
  CheckPairs([](std::uint64_t i) { return Uniform({.seed = i}, 5); },
             [](std::uint64_t i) { return Uniform({.seed = i + 1}, 5); });
  CheckPairs([](std::uint64_t i) { return Uniform({.seed = 0, .index = i}, 5); },
             [](std::uint64_t i) { return Uniform({.seed = 1, .index = i}, 5); });
}

TEST_CASE("neighbouring attempts are independent") {
  CheckPairs([](std::uint64_t i) { return Uniform({.index = i}, 5); },
             [](std::uint64_t i) { return Uniform({.index = i, .attempt = 1}, 5); });
}

TEST_CASE("streams of similar names are independent") {
  const StreamId params = Child(kRootStream, "params");
  const StreamId a = Child(params, "wall_1");
  const StreamId b = Child(params, "wall_2");
  CheckPairs([a](std::uint64_t i) { return Uniform({.index = i}, a); },
             [b](std::uint64_t i) { return Uniform({.index = i}, b); });
}

TEST_CASE("the items of a long list are independent of their neighbours") {
  const StreamId list = Child(kRootStream, "parts");
  CheckPairs([list](std::uint64_t i) { return Uniform({}, Child(list, std::size_t{i})); },
             [list](std::uint64_t i) { return Uniform({}, Child(list, std::size_t{i} + 1)); });
}

TEST_CASE("the numbers of one block are independent") {
  for (std::size_t word = 1; word < 4; ++word) {
    CheckPairs([](std::uint64_t i) { return Uniform({.index = i}, 5); },
               [word](std::uint64_t i) { return Uniform({.index = i}, 5, word); });
  }
}

TEST_CASE("the swap of seed and index gives another draw") {
  CheckPairs([](std::uint64_t i) { return Uniform({.seed = 3, .index = i}, 5); },
             [](std::uint64_t i) { return Uniform({.seed = i, .index = 3}, 5); });
}

TEST_CASE("uniforms are uniform over indices, seeds and streams") {
  const auto identity = [](double u) { return u; };
  std::vector<double> by_index;
  std::vector<double> by_seed;
  std::vector<double> by_stream;
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    by_index.push_back(Uniform({.index = i}, 5));
    by_seed.push_back(Uniform({.seed = i}, 5));
    by_stream.push_back(Uniform({}, Child(kRootStream, std::size_t{i})));
  }
  CHECK(KolmogorovSmirnov(by_index, identity) > kLevel);
  CHECK(KolmogorovSmirnov(by_seed, identity) > kLevel);
  CHECK(KolmogorovSmirnov(by_stream, identity) > kLevel);
}

}  // namespace
}  // namespace mjforge::sample
