#include "mjforge/report/histogram.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace mjforge::report {
namespace {

Histogram HistogramOf(const std::vector<double>& values) {
  Histogram histogram;
  for (const double value : values) histogram.Add(value);
  return histogram;
}

// A thousand numbers without an order: i * golden ratio, modulo 1.
std::vector<double> Scattered() {
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back(std::fmod(i * 0.6180339887498949, 1.0));
  return values;
}

TEST_CASE("a histogram without numbers has none in any bin") {
  const Histogram histogram;
  CHECK(histogram.count() == 0);
  CHECK(histogram.Bins(0, 1, 3) == std::vector<std::uint64_t>{0, 0, 0});
}

TEST_CASE("minimum, maximum, mean and deviation are exact") {
  const Histogram histogram = HistogramOf({3, -1, 4, 2});
  CHECK(histogram.count() == 4);
  CHECK(histogram.min() == -1);
  CHECK(histogram.max() == 4);
  CHECK(histogram.mean() == Approx(2));
  CHECK(histogram.StandardDeviation() == Approx(std::sqrt(3.5)));
}

TEST_CASE("bins count what is in them, the last one its upper end, too") {
  CHECK(HistogramOf({0, 0.1, 0.4, 0.6, 0.9, 1}).Bins(0, 1, 2) == std::vector<std::uint64_t>{3, 3});
  CHECK(HistogramOf({-3, -1, 0, 5}).Bins(-4, 0, 4) == std::vector<std::uint64_t>{0, 1, 0, 2});
}

TEST_CASE("bins of evenly spread numbers are as high as each other") {
  const std::vector<std::uint64_t> bins = HistogramOf(Scattered()).Bins(0, 1, 10);
  for (const std::uint64_t count : bins) CHECK(std::abs(static_cast<double>(count) - 100) <= 2);
  CHECK(std::accumulate(bins.begin(), bins.end(), std::uint64_t{0}) == 1000);
}

TEST_CASE("histograms joined are the histogram of all numbers") {
  const std::vector<double> scattered = Scattered();
  const std::vector<std::vector<double>> others = {{},     {0.5},           {-1e6, 3e5},
                                                   {1e-9}, {1e300, -1e300}, scattered};
  for (const std::vector<double>& other : others) {
    std::vector<double> both = scattered;
    both.insert(both.end(), other.begin(), other.end());
    const Histogram expected = HistogramOf(both);
    for (const bool is_swapped : {false, true}) {
      Histogram joined = HistogramOf(is_swapped ? other : scattered);
      joined.Append(HistogramOf(is_swapped ? scattered : other));
      CHECK(joined.count() == expected.count());
      CHECK(joined.min() == expected.min());
      CHECK(joined.max() == expected.max());
      const double lo = expected.min();
      const double hi = expected.max();
      CHECK(joined.mean() == Approx(expected.mean()).margin(1e-15 * hi));
      CHECK(joined.StandardDeviation() == Approx(expected.StandardDeviation()));
      CHECK(joined.Bins(lo, hi, 32) == expected.Bins(lo, hi, 32));
      CHECK(joined.Quantile(0.3) == expected.Quantile(0.3));
    }
  }
}

TEST_CASE("the order of the numbers does not matter") {
  std::vector<double> values = Scattered();
  values.push_back(-1e6);
  values.push_back(3e5);
  const std::vector<std::uint64_t> forwards = HistogramOf(values).Bins(-1e6, 3e5, 32);
  std::reverse(values.begin(), values.end());
  CHECK(HistogramOf(values).Bins(-1e6, 3e5, 32) == forwards);
  std::sort(values.begin(), values.end());
  CHECK(HistogramOf(values).Bins(-1e6, 3e5, 32) == forwards);
}

TEST_CASE("quantiles are as exact as a cell is wide") {
  const Histogram histogram = HistogramOf(Scattered());
  for (const double q : {0.0, 0.1, 0.5, 0.99})
    CHECK(histogram.Quantile(q) == Approx(q).margin(2e-3));
  CHECK(histogram.Quantile(1) == histogram.max());
}

TEST_CASE("numbers of all sizes fit, and what is not finite is passed over") {
  Histogram histogram = HistogramOf({0, 5e-324, -5e-324, 1e-300, 1});
  CHECK(histogram.count() == 5);
  histogram.Add(std::numeric_limits<double>::infinity());
  histogram.Add(std::numeric_limits<double>::quiet_NaN());
  CHECK(histogram.count() == 5);
  histogram.Add(1e300);
  CHECK(histogram.max() == 1e300);
  CHECK(histogram.Bins(0, 1e300, 2) == std::vector<std::uint64_t>{5, 1});
}

TEST_CASE("numbers that hardly differ are told apart") {
  const Histogram histogram = HistogramOf({1e9, 1e9 + 1, 1e9 + 2, 1e9 + 2});
  CHECK(histogram.Bins(1e9 - 0.5, 1e9 + 2.5, 3) == std::vector<std::uint64_t>{1, 1, 2});
}

TEST_CASE("one number many times is one cell") {
  Histogram histogram;
  for (int i = 0; i < 100; ++i) histogram.Add(0.3);
  CHECK(histogram.min() == 0.3);
  CHECK(histogram.max() == 0.3);
  CHECK(histogram.Quantile(0.5) == 0.3);
  CHECK(histogram.StandardDeviation() == Approx(0).margin(1e-12));
  CHECK(histogram.Bins(0.2, 0.4, 1) == std::vector<std::uint64_t>{100});
}

}  // namespace
}  // namespace mjforge::report
