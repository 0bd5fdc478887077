// Tests of random samples.

#include "mjforge/report/random_sample.h"

#include <catch2/catch.hpp>
#include <string>

namespace mjforge::report {
namespace {

RandomSample<int> SampleOf(int begin, int end, std::size_t most) {
  RandomSample<int> sample(most);
  for (int i = begin; i < end; ++i) sample.Add(static_cast<std::uint64_t>(i), i);
  CHECK(sample.seen() == static_cast<std::uint64_t>(end - begin));
  return sample;
}

TEST_CASE("all of few are kept, in the order of their indices") {
  CHECK(SampleOf(0, 0, 4).Take(4).empty());
  CHECK(SampleOf(0, 3, 4).Take(10) == std::vector<int>{0, 1, 2});
  CHECK(SampleOf(0, 8, 8).Take(8) == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
}

TEST_CASE("of many there are as many as were asked for, spread over all") {
  for (const int seen : {100, 1000, 12345}) {
    CAPTURE(seen);
    const std::vector<int> taken = SampleOf(0, seen, 40).Take(20);
    REQUIRE(taken.size() == 20);
    CHECK(std::ranges::is_sorted(taken));
    CHECK(std::ranges::adjacent_find(taken) == taken.end());
    CHECK(taken.front() < seen / 2);
    CHECK(taken.back() > seen / 2);
  }
}

TEST_CASE("a sample does not depend on how its items were divided") {
  const std::vector<int> whole = SampleOf(0, 1000, 50).Take(50);
  for (const int middle : {0, 1, 333, 999, 1000}) {
    RandomSample<int> parts = SampleOf(middle, 1000, 50);
    parts.Append(SampleOf(0, middle, 50));
    CHECK(parts.seen() == 1000);
    CHECK(parts.Take(50) == whole);
  }
}

TEST_CASE("a regularity of the indices does not show in the sample") {
  // A grid of four values: every fourth variant has the same value.
  std::vector<int> counts(4);
  for (const int i : SampleOf(0, 10'000, 400).Take(400)) ++counts[static_cast<std::size_t>(i % 4)];
  for (const int count : counts) CHECK(std::abs(count - 100) < 30);
}

TEST_CASE("a sample of none keeps none") { CHECK(SampleOf(0, 100, 0).Take(10).empty()); }

}  // namespace
}  // namespace mjforge::report
