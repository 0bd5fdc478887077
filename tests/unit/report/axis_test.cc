#include "mjforge/report/axis.h"

#include <catch2/catch.hpp>

namespace mjforge::report {
namespace {

std::string Labels(const Axis& axis, int count) {
  std::string text;
  for (const Axis::Tick& tick : axis.Ticks(count)) text += tick.label + " ";
  return text;
}

TEST_CASE("ticks of an axis are round numbers") {
  CHECK(Labels(Axis(Scale::kLinear, 0, 1, 0, 100), 5) == "0 0.2 0.4 0.6 0.8 1 ");
  CHECK(Labels(Axis(Scale::kLinear, 0.1, 0.25, 0, 100), 5) ==
        "0.1 0.12 0.14 0.16 0.18 0.2 0.22 0.24 ");
  CHECK(Labels(Axis(Scale::kLinear, -1, 1, 0, 100), 4) == "-1 -0.5 0 0.5 1 ");
  CHECK(Labels(Axis(Scale::kLinear, 0, 31234, 0, 100), 4) == "0 10000 20000 30000 ");
  CHECK(Labels(Axis(Scale::kLinear, 1e-7, 3e-7, 0, 100), 4) ==
        "1e-07 1.5e-07 2e-07 2.5e-07 3e-07 ");
}

TEST_CASE("ticks of a logarithmic axis are decades, with 2 and 5 where they are few") {
  CHECK(Labels(Axis(Scale::kLogarithmic, 1, 1e4, 0, 100), 5) == "1 10 100 1000 1e+04 ");
  CHECK(Labels(Axis(Scale::kLogarithmic, 3, 60, 0, 100), 5) == "5 10 20 50 ");
  CHECK(Labels(Axis(Scale::kLogarithmic, 1e-9, 1e9, 0, 100), 5) ==
        "1e-09 1e-06 0.001 1 1000 1e+06 1e+09 ");
}

TEST_CASE("an axis puts its ends at its places, and a logarithmic one decades apart") {
  const Axis linear(Scale::kLinear, 2, 4, 100, 0);
  CHECK(linear.At(2) == Approx(100));
  CHECK(linear.At(3) == Approx(50));
  CHECK(linear.At(4) == Approx(0).margin(1e-9));
  const Axis logarithmic(Scale::kLogarithmic, 1, 100, 0, 10);
  CHECK(logarithmic.At(10) == Approx(5));
}

TEST_CASE("an axis of one number has room about it") {
  const Axis axis(Scale::kLinear, 0.2, 0.2, 0, 100);
  CHECK(axis.At(0.2) == Approx(50));
  CHECK(Axis(Scale::kLinear, 0, 0, 0, 100).At(0) == Approx(50));
  CHECK(Axis(Scale::kLogarithmic, 3, 3, 0, 100).lo() > 0);
}

TEST_CASE("rounded, an axis begins and ends at a tick") {
  Axis axis(Scale::kLinear, 0.13, 0.94, 0, 100);
  axis.Round(4);
  CHECK(axis.lo() == Approx(0).margin(1e-12));
  CHECK(axis.hi() == Approx(1));
  Axis exact(Scale::kLinear, 0, 100, 0, 100);
  exact.Round(4);
  CHECK(exact.hi() == Approx(100));
}

TEST_CASE("numbers over decades want a logarithm, unless they are evenly spread") {
  CHECK(WantsLogarithm(0.01, 10, 0.3));
  CHECK_FALSE(WantsLogarithm(0.01, 10, 5));
  CHECK_FALSE(WantsLogarithm(0.1, 2, 0.2));
  CHECK_FALSE(WantsLogarithm(0, 10, 0.1));
  CHECK_FALSE(WantsLogarithm(-1, 10, 0.1));
}

TEST_CASE("numbers are shown with the digits that count") {
  CHECK(ShortNumber(0) == "0");
  CHECK(ShortNumber(-0.0) == "0");
  CHECK(ShortNumber(0.25) == "0.25");
  CHECK(ShortNumber(1.0 / 3) == "0.3333");
  CHECK(ShortNumber(12345.6) == "12346");
  CHECK(ShortNumber(3.1e-7) == "3.1e-07");
  CHECK(ShortNumber(1.2e9) == "1.2e+09");
}

}  // namespace
}  // namespace mjforge::report
