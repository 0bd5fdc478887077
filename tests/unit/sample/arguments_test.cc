// Messages about invalid arguments and limits of each distribution.

#include <catch2/catch.hpp>
#include <vector>

#include "mjforge/sample/distributions.h"

namespace mjforge::sample {
namespace {

using spec::Distribution;

std::string Wrong(Distribution distribution, const std::vector<double>& arguments,
                  std::optional<Interval> limits = {}) {
  return CheckArguments(distribution, arguments, limits).value_or("nothing");
}

TEST_CASE("a reversed range is empty") {
  const std::string range = "range 0.03 .. 0.02 is empty: its lower end is above its upper end";
  CHECK(Wrong(Distribution::kUniform, {0.03, 0.02}) == range);
  CHECK(Wrong(Distribution::kLogUniform, {0.03, 0.02}) == range);
  CHECK(Wrong(Distribution::kTriangular, {0.03, 0.025, 0.02}) == range);
  CHECK(Wrong(Distribution::kBeta, {1, 1}, Interval{0.03, 0.02}) == range);
  CHECK(Wrong(Distribution::kInteger, {3, 2}) ==
        "range 3 .. 2 is empty: its lower end is above its upper end");
  CHECK(Wrong(Distribution::kNormal, {0, 1}, Interval{3, 2}) ==
        "clip 3 .. 2 is empty: its lower end is above its upper end");
}

TEST_CASE("a range of one number is good") {
  CHECK(Wrong(Distribution::kUniform, {2, 2}) == "nothing");
  CHECK(Wrong(Distribution::kLogUniform, {2, 2}) == "nothing");
  CHECK(Wrong(Distribution::kTriangular, {2, 2, 2}) == "nothing");
  CHECK(Wrong(Distribution::kInteger, {2, 2}) == "nothing");
  CHECK(Wrong(Distribution::kBeta, {1, 1}, Interval{2, 2}) == "nothing");
  CHECK(Wrong(Distribution::kNormal, {0, 1}, Interval{2, 2}) == "nothing");
}

TEST_CASE("each distribution names its bad argument") {
  CHECK(Wrong(Distribution::kLogUniform, {0, 1}) == "lower end 0 is not greater than 0");
  CHECK(Wrong(Distribution::kTriangular, {1, 5, 3}) == "mode 5 is outside the range 1 .. 3");
  CHECK(Wrong(Distribution::kNormal, {0, -1}) == "standard deviation -1 is negative");
  CHECK(Wrong(Distribution::kLogNormal, {0, -0.5}) == "sigma -0.5 is negative");
  CHECK(Wrong(Distribution::kBeta, {0, 1}) == "first shape 0 is not greater than 0");
  CHECK(Wrong(Distribution::kBeta, {1, -2}) == "second shape -2 is not greater than 0");
  CHECK(Wrong(Distribution::kExponential, {0}) == "rate 0 is not greater than 0");
  CHECK(Wrong(Distribution::kPoisson, {-1}) == "mean -1 is negative");
  CHECK(Wrong(Distribution::kPoisson, {2e6}) == "mean 2000000 is above 1000000");
  CHECK(Wrong(Distribution::kInteger, {0.5, 2}) ==
        "end 0.5 of the integer range is not a whole number");
  CHECK(Wrong(Distribution::kInteger, {0, 1e17}) ==
        "end 1e+17 of the integer range is beyond 2^53");
  CHECK(Wrong(Distribution::kBernoulli, {1.5}) == "probability 1.5 is not between 0 and 1");
  CHECK(Wrong(Distribution::kBernoulli, {-0.1}) == "probability -0.1 is not between 0 and 1");
}

TEST_CASE("limits that no value can meet are wrong") {
  CHECK(Wrong(Distribution::kNormal, {0, 1}, Interval{200, 201}) ==
        "clip 200 .. 201 leaves no possible value");
  CHECK(Wrong(Distribution::kNormal, {0, 0}, Interval{1, 2}) ==
        "clip 1 .. 2 leaves no possible value");
  CHECK(Wrong(Distribution::kLogNormal, {0, 1}, Interval{-2, 0}) ==
        "clip -2 .. 0 leaves no possible value");
  CHECK(Wrong(Distribution::kExponential, {1}, Interval{-2, -1}) ==
        "clip -2 .. -1 leaves no possible value");
  CHECK(Wrong(Distribution::kPoisson, {3}, Interval{2.1, 2.9}) ==
        "clip 2.1 .. 2.9 leaves no possible value");
  CHECK(Wrong(Distribution::kPoisson, {3}, Interval{900, 901}) ==
        "clip 900 .. 901 leaves no possible value");
  CHECK(Wrong(Distribution::kPoisson, {0}, Interval{1, 2}) ==
        "clip 1 .. 2 leaves no possible value");
}

TEST_CASE("limits far out are good while probability is left there") {
  CHECK(Wrong(Distribution::kNormal, {0, 1}, Interval{5, 6}) == "nothing");
  CHECK(Wrong(Distribution::kNormal, {0, 1}, Interval{-40, -39}) == "nothing");
  CHECK(Wrong(Distribution::kNormal, {1, 0}, Interval{0, 2}) == "nothing");
  CHECK(Wrong(Distribution::kExponential, {1}, Interval{5000, 5001}) == "nothing");
  CHECK(Wrong(Distribution::kPoisson, {3}, Interval{40, 41}) == "nothing");
}

}  // namespace
}  // namespace mjforge::sample
