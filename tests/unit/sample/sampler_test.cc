// Sampling methods: dependence on the key and the batch, redraws, Latin hypercube strata.

#include "mjforge/sample/sampler.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "loading.h"

namespace mjforge::sample {
namespace {

constexpr Method kMethods[] = {Method::kRandom, Method::kSobol, Method::kLatin, Method::kGrid};

StreamId ParameterStreamId(std::string_view name) {
  return Child(Child(Child(kRootStream, "t"), "params"), name);
}

TEST_CASE("methods have names") {
  REQUIRE(MethodNames().size() == 4);
  for (const Method method : kMethods) CHECK(FindMethod(MethodName(method)) == method);
  CHECK(MethodName(Method::kLatin) == "latin");
  CHECK_FALSE(FindMethod("halton"));
}

TEST_CASE("numbers depend on key, stream and batch alone") {
  const Family family = Load("{a: 0 .. 1, b: {choice: [x, y]}, c: {on_sphere: 1}}");
  for (const Method method : kMethods) {
    const Sampler there(*family.spec, method, 5, 12);
    std::map<std::pair<std::uint64_t, StreamId>, std::array<double, 4>> numbers;
    const StreamId streams[] = {ParameterStreamId("a"), ParameterStreamId("c"), 77};
    for (std::uint64_t index = 0; index < 40; ++index) {
      for (const StreamId stream : streams) {
        numbers[{index, stream}] = there.Uniforms({.seed = 5, .index = index}, stream);
      }
    }
    const Sampler back(*family.spec, method, 5, 12);
    for (std::uint64_t index = 40; index-- > 0;) {
      for (const StreamId stream : streams) {
        CHECK(back.Uniforms({.seed = 5, .index = index}, stream) == numbers[{index, stream}]);
      }
    }
  }
}

TEST_CASE("redraws are random, so rejecting one item moves no other") {
  const Family family = Load("{a: 0 .. 1}");
  const StreamId stream = ParameterStreamId("a");
  for (const Method method : kMethods) {
    const Sampler sampler(*family.spec, method, 5, 8);
    for (std::uint64_t index = 0; index < 30; ++index) {
      const DrawKey again = {.seed = 5, .index = index, .attempt = 1};
      CHECK(sampler.Uniforms(again, stream) == Uniforms(again, stream));
      const DrawKey first = {.seed = 5, .index = index};
      const bool same = sampler.Uniforms(first, stream) == Uniforms(first, stream);
      CHECK(same == (method == Method::kRandom));
    }
  }
}

TEST_CASE("rejected items redraw at random, the others keep their place") {
  Family free = Load("{a: 0 .. 1, b: 0 .. 1}");
  Family strict = Load("{a: 0 .. 1, b: 0 .. 1}", "require: [a + b < 1.2]");
  for (const Method method : {Method::kSobol, Method::kLatin, Method::kGrid}) {
    const Sampler sampler(*free.spec, method, 5, 64);
    int redrawn = 0;
    for (std::uint64_t index = 0; index < 64; ++index) {
      const DrawKey key = {.seed = 5, .index = index};
      const auto values = Sample(*strict.spec, key, kRootStream, {}, strict.findings, &sampler);
      REQUIRE(values);
      if (values->key().attempt > 0) {
        ++redrawn;
        CHECK(std::get<double>(values->Parameter(0)) == strict.Number("a", values->key()));
      } else {
        CHECK(std::get<double>(values->Parameter(0)) == free.Number("a", key, &sampler));
      }
    }
    CHECK(redrawn > 5);
    CHECK(redrawn < 40);
  }
}

TEST_CASE("latin has one item of a block in each N-th, for every number of every stream") {
  const Family family = Load("{a: 0 .. 1}");
  for (const std::uint64_t size : {1, 2, 3, 7, 100}) {
    const Sampler latin(*family.spec, Method::kLatin, 9, size);
    for (const StreamId stream : {ParameterStreamId("a"), StreamId{12345}, Child(99, "density")}) {
      for (std::uint64_t block = 0; block < 3; ++block) {
        std::array<std::set<std::uint64_t>, 4> strata;
        for (std::uint64_t i = 0; i < size; ++i) {
          const auto u = latin.Uniforms({.seed = 9, .index = block * size + i}, stream);
          for (std::size_t c = 0; c < 4; ++c) {
            CHECK((u[c] > 0 && u[c] < 1));
            strata[c].insert(static_cast<std::uint64_t>(u[c] * static_cast<double>(size)));
          }
        }
        for (const auto& hit : strata) CHECK(hit.size() == size);
      }
    }
  }
}

TEST_CASE("latin orders each block, stream and number in its own way") {
  const Family family = Load("{a: 0 .. 1}");
  const Sampler latin(*family.spec, Method::kLatin, 9, 50);
  std::set<std::vector<std::uint64_t>> orders;
  for (const StreamId stream : {StreamId{1}, StreamId{2}}) {
    for (std::uint64_t block = 0; block < 4; ++block) {
      std::array<std::vector<std::uint64_t>, 4> order;
      for (std::uint64_t i = 0; i < 50; ++i) {
        const auto u = latin.Uniforms({.seed = 9, .index = block * 50 + i}, stream);
        for (std::size_t c = 0; c < 4; ++c) {
          order[c].push_back(static_cast<std::uint64_t>(u[c] * 50));
        }
      }
      orders.insert(order.begin(), order.end());
    }
  }
  CHECK(orders.size() == 32);
}

TEST_CASE("a parameter added at the end leaves sobol and latin draws as they are") {
  Family before = Load("{a: 0 .. 1, b: {normal: [0, 1]}, c: {choice: [1, 2, 3]}}");
  Family after = Load("{a: 0 .. 1, b: {normal: [0, 1]}, c: {choice: [1, 2, 3]}, d: 0 .. 1}");
  for (const Method method : {Method::kSobol, Method::kLatin}) {
    const Sampler few(*before.spec, method, 2, 32);
    const Sampler more(*after.spec, method, 2, 32);
    for (std::uint64_t index = 0; index < 40; ++index) {
      const DrawKey key = {.seed = 2, .index = index};
      for (const char* name : {"a", "b", "c"}) {
        CHECK(before.Number(name, key, &few) == after.Number(name, key, &more));
      }
    }
  }
}

TEST_CASE("without a batch latin and grid are random, and sobol is itself") {
  const Family family = Load("{a: 0 .. 1}");
  const StreamId stream = ParameterStreamId("a");
  const DrawKey key = {.seed = 5, .index = 3};
  for (const Method method : {Method::kLatin, Method::kGrid}) {
    CHECK(Sampler(*family.spec, method, 5, 0).Uniforms(key, stream) == Uniforms(key, stream));
  }
  CHECK(Sampler(*family.spec, Method::kSobol, 5, 0).Uniforms(key, stream) ==
        Sampler(*family.spec, Method::kSobol, 5, 10).Uniforms(key, stream));
}

TEST_CASE("who depends on the batch's size says so") {
  const Family plain = Load("{a: 0 .. 1}");
  const Family exact = Load("{a: {choice: [1, 2], exact: true}}");
  const Family inexact = Load("{a: {choice: [1, 2], exact: false}}");
  const Family part =
      Load("{a: 1}", "parts: [{name: b, type: sphere, size: {choice: [1, 2], exact: true}}]");
  for (const Method method : kMethods) {
    const bool always = method == Method::kLatin || method == Method::kGrid;
    CHECK(Sampler::NeedsBatch(*plain.spec, method) == always);
    CHECK(Sampler::NeedsBatch(*inexact.spec, method) == always);
    CHECK(Sampler::NeedsBatch(*exact.spec, method));
    CHECK(Sampler::NeedsBatch(*part.spec, method));
    CHECK(Sampler(*plain.spec, method, 1, 5).NeedsBatch() == always);
  }
}

}  // namespace
}  // namespace mjforge::sample
