// Choices with `exact: true`, whose options have planned counts over a batch.

#include <catch2/catch.hpp>
#include <map>

#include "loading.h"
#include "mjforge/sample/apportion.h"

namespace mjforge::sample {
namespace {

constexpr const char* kThree = "{a: {choice: [0, 1, 2], weights: [0.5, 0.26, 0.24], exact: true}}";

TEST_CASE("each block of a batch has the counts of the largest remainders") {
  for (const std::vector<double>& weights :
       {std::vector<double>{1, 1, 1}, {0.5, 0.26, 0.24}, {0, 3, 1}, {7, 0.001, 2}}) {
    Family family =
        Load("{a: {choice: [0, 1, 2], weights: [" + std::to_string(weights[0]) + ", " +
             std::to_string(weights[1]) + ", " + std::to_string(weights[2]) + "], exact: true}}");
    for (const std::uint64_t size : {1, 2, 3, 10, 97, 128}) {
      for (const std::uint64_t seed : {0, 1, 8}) {
        const Sampler sampler(*family.spec, Method::kRandom, seed, size);
        for (std::uint64_t block = 0; block < 3; ++block) {
          std::vector<std::uint64_t> counts(3);
          for (std::uint64_t i = 0; i < size; ++i) {
            const DrawKey key = {.seed = seed, .index = block * size + i};
            ++counts[static_cast<std::size_t>(family.Number("a", key, &sampler))];
          }
          CHECK(counts == LargestRemainder(weights, size));
        }
      }
    }
  }
}

TEST_CASE("without weights all options are alike") {
  Family family = Load("{a: {choice: [0, 1, 2], exact: true}}");
  const Sampler sampler(*family.spec, Method::kRandom, 4, 11);
  std::map<double, int> counts;
  for (std::uint64_t index = 0; index < 11; ++index) {
    ++counts[family.Number("a", {.seed = 4, .index = index}, &sampler)];
  }
  CHECK(counts == std::map<double, int>{{0, 4}, {1, 4}, {2, 3}});
}

TEST_CASE("the same counts are there under every method, and the same options") {
  Family family = Load("{x: 0 .. 1, a: {choice: [0, 1, 2], weights: [1, 2, 1], exact: true}}");
  const Sampler random(*family.spec, Method::kRandom, 4, 16);
  for (const Method method : {Method::kSobol, Method::kLatin, Method::kGrid}) {
    const Sampler sampler(*family.spec, method, 4, 16);
    for (std::uint64_t index = 0; index < 32; ++index) {
      const DrawKey key = {.seed = 4, .index = index};
      CHECK(family.Number("a", key, &sampler) == family.Number("a", key, &random));
    }
  }
}

TEST_CASE("the order hangs on seed, block and path") {
  Family family = Load("{a: {choice: [0, 1], exact: true}, b: {choice: [0, 1], exact: true}}");
  const auto order = [&](const char* name, std::uint64_t seed, std::uint64_t block) {
    const Sampler sampler(*family.spec, Method::kRandom, seed, 40);
    std::string text;
    for (std::uint64_t i = 0; i < 40; ++i) {
      text +=
          family.Number(name, {.seed = seed, .index = block * 40 + i}, &sampler) > 0 ? '1' : '0';
    }
    return text;
  };
  const std::string first = order("a", 1, 0);
  CHECK(order("a", 1, 0) == first);
  CHECK(order("a", 1, 1) != first);
  CHECK(order("a", 2, 0) != first);
  CHECK(order("b", 1, 0) != first);
}

TEST_CASE("redraws keep the option, so that the batch stays exact") {
  Family family =
      Load("{a: {choice: [0, 1, 2], weights: [0.5, 0.26, 0.24], exact: true}, x: 0 .. 1}",
           "require: [x > 0.7]");
  const Sampler sampler(*family.spec, Method::kRandom, 6, 50);
  std::vector<std::uint64_t> counts(3);
  std::uint64_t attempts = 0;
  for (std::uint64_t index = 0; index < 50; ++index) {
    const DrawKey key = {.seed = 6, .index = index};
    const auto values = Sample(*family.spec, key, kRootStream, {}, family.findings, &sampler);
    REQUIRE(values);
    attempts += values->key().attempt;
    const double option = std::get<double>(values->Parameter(0));
    CHECK(option == family.Number("a", key, &sampler));
    ++counts[static_cast<std::size_t>(option)];
  }
  CHECK(attempts > 50);
  CHECK(counts == std::vector<std::uint64_t>{25, 13, 12});
}

TEST_CASE("a requirement that only an exact choice could meet is not retried") {
  Family family = Load(kThree, "require: [a > 5]");
  const Sampler sampler(*family.spec, Method::kRandom, 0, 10);
  CHECK_FALSE(Sample(*family.spec, {}, kRootStream, {}, family.findings, &sampler));
  REQUIRE(family.findings.size() == 1);
  CHECK(family.findings[0].hint == "no parameter is drawn, so a redraw cannot help");
}

TEST_CASE("without a batch an exact choice is drawn as any other") {
  Family exact = Load(kThree);
  Family plain = Load("{a: {choice: [0, 1, 2], weights: [0.5, 0.26, 0.24]}}");
  const Sampler unknown(*exact.spec, Method::kRandom, 3, 0);
  for (std::uint64_t index = 0; index < 50; ++index) {
    const DrawKey key = {.seed = 3, .index = index};
    CHECK(exact.Number("a", key) == plain.Number("a", key));
    CHECK(exact.Number("a", key, &unknown) == plain.Number("a", key));
  }
  Family strict = Load(kThree, "require: [a > 1]");
  CHECK(Sample(*strict.spec, {}, kRootStream, {}, strict.findings));
}

TEST_CASE("draws inside the options and texts work as in any choice") {
  Family family =
      Load("{a: {choice: [1 .. 2, 3 .. 4], exact: true}, t: {choice: [x, y], exact: true}}");
  const Sampler sampler(*family.spec, Method::kRandom, 3, 10);
  int low = 0;
  int x = 0;
  for (std::uint64_t index = 0; index < 10; ++index) {
    const DrawKey key = {.seed = 3, .index = index};
    const double a = family.Number("a", key, &sampler);
    CHECK(((a >= 1 && a <= 2) || (a >= 3 && a <= 4)));
    if (a <= 2) ++low;
    if (std::get<std::string>(family.Parameter("t", key, &sampler)) == "x") ++x;
  }
  CHECK(low == 5);
  CHECK(x == 5);
}

TEST_CASE("weights that cannot be are found") {
  Family family = Load(
      "{a: {choice: [1, 2], weights: [1, -1], exact: true}, "
      "b: {choice: [1, 2], weights: [0, 0], exact: true}}");
  const Sampler sampler(*family.spec, Method::kRandom, 0, 10);
  Sample(*family.spec, {}, kRootStream, {}, family.findings, &sampler);
  CHECK(family.Report() ==
        Strings{"3:43 sample/bad-argument: weight 2 of the choice is -1; it must not be negative "
                "0/0",
                "3:65 sample/bad-argument: all weights of the choice are 0; one must be positive "
                "0/0"});
}

}  // namespace
}  // namespace mjforge::sample
