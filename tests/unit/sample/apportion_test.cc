// Apportionment by largest remainders: ties, weights of 0, rounding errors, totals.

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <vector>

#include "mjforge/sample/apportion.h"

namespace mjforge::sample {
namespace {

using Weights = std::vector<double>;
using Counts = std::vector<std::uint64_t>;

TEST_CASE("the largest remainders get what is left") {
  CHECK(LargestRemainder(Weights{1, 2, 1}, 100) == Counts{25, 50, 25});
  CHECK(LargestRemainder(Weights{0.5, 0.26, 0.24}, 10) == Counts{5, 3, 2});
  // Shares of 7.656, 7.179, 5.305 and 0.861.
  CHECK(LargestRemainder(Weights{7656, 7179, 5305, 861}, 21) == Counts{8, 7, 5, 1});
  CHECK(LargestRemainder(Weights{3}, 7) == Counts{7});
}

TEST_CASE("of equal remainders the first ones get more") {
  CHECK(LargestRemainder(Weights{1, 1, 1}, 10) == Counts{4, 3, 3});
  CHECK(LargestRemainder(Weights{1, 1, 1}, 11) == Counts{4, 4, 3});
  CHECK(LargestRemainder(Weights{0.1, 0.1, 0.1}, 10) == Counts{4, 3, 3});
  CHECK(LargestRemainder(Weights{0.3, 0.1, 0.3, 0.3}, 5) == Counts{2, 1, 1, 1});
}

TEST_CASE("a weight of 0 gets nothing, whatever is left") {
  CHECK(LargestRemainder(Weights{0, 1, 0, 1, 1}, 2) == Counts{0, 1, 0, 1, 0});
  CHECK(LargestRemainder(Weights{0, 1}, 3) == Counts{0, 3});
}

TEST_CASE("rounding errors move no item") {
  // 0.1 + 0.2 is more than 0.3, and 0.7 * 10 less than 7.
  CHECK(LargestRemainder(Weights{0.1, 0.2, 0.7}, 10) == Counts{1, 2, 7});
  CHECK(LargestRemainder(Weights{0.7, 0.1, 0.2}, 1000) == Counts{700, 100, 200});
  CHECK(LargestRemainder(Weights{1e308, 1e308}, 4) == Counts{2, 2});
  CHECK(LargestRemainder(Weights{5e-324, 5e-324}, 4) == Counts{2, 2});
}

TEST_CASE("counts add up and are less than one off their share") {
  for (std::uint64_t total = 1; total < 2000; total = total * 3 / 2 + 1) {
    for (std::size_t options = 1; options < 9; ++options) {
      Weights weights;
      for (std::size_t i = 0; i < options; ++i) {
        weights.push_back(static_cast<double>((i * 37 + total) % 11 + 1));
      }
      const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
      const Counts counts = LargestRemainder(weights, total);
      CHECK(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) == total);
      for (std::size_t i = 0; i < options; ++i) {
        const double share = static_cast<double>(total) * weights[i] / sum;
        CHECK(std::abs(static_cast<double>(counts[i]) - share) < 1 + 1e-9);
      }
    }
  }
  const Counts huge = LargestRemainder(Weights{1, 1, 1}, std::uint64_t{1} << 52);
  CHECK(huge[0] + huge[1] + huge[2] == std::uint64_t{1} << 52);
}

}  // namespace
}  // namespace mjforge::sample
