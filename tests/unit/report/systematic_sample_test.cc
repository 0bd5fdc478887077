#include "mjforge/report/systematic_sample.h"

#include <catch2/catch.hpp>
#include <string>

namespace mjforge::report {
namespace {

std::vector<int> SampleOf(int seen, std::size_t least, std::size_t count) {
  SystematicSample<int> sample(least);
  for (int i = 0; i < seen; ++i) sample.Add(i);
  CHECK(sample.seen() == static_cast<std::uint64_t>(seen));
  return sample.Take(count);
}

TEST_CASE("all of few are kept, in their order") {
  CHECK(SampleOf(0, 4, 4).empty());
  CHECK(SampleOf(3, 4, 10) == std::vector<int>{0, 1, 2});
  CHECK(SampleOf(8, 4, 8) == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7});
}

TEST_CASE("of many there are as many as were asked for, evenly spread") {
  for (const int seen : {9, 16, 17, 100, 1000, 12345}) {
    CAPTURE(seen);
    const std::vector<int> taken = SampleOf(seen, 8, 8);
    REQUIRE(taken.size() == 8);
    CHECK(taken.front() == 0);
    CHECK(taken.back() >= seen / 2);
    for (std::size_t i = 1; i < taken.size(); ++i) {
      CHECK(taken[i] > taken[i - 1]);
      CHECK(taken[i] - taken[i - 1] <= seen / 4 + 1);
    }
  }
}

TEST_CASE("what is kept stays whole") {
  SystematicSample<std::string> sample(4);
  for (int i = 0; i < 100; ++i)
    sample.Add("a text that is too long for its own object " + std::to_string(i));
  for (const std::string& text : sample.Take(4)) CHECK(text.size() > 40);
}

TEST_CASE("a sample of none keeps none") { CHECK(SampleOf(100, 0, 10).empty()); }

}  // namespace
}  // namespace mjforge::report
