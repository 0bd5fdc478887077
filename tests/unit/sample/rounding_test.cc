// Rounding of draws: digits, narrow ranges, ends of ranges.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "mjforge/expr/expr.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double Round(double value) { return RoundWithin(-kInfinity, kInfinity, value); }

// Decimal digits of the shortest text, without the exponent and outer zeros.
std::size_t Digits(double value) {
  std::string text = expr::ExactNumberText(std::abs(value));
  text = text.substr(0, text.find('e'));
  std::erase(text, '.');
  text.erase(0, text.find_first_not_of('0'));
  return text.find_last_not_of('0') + 1;
}

TEST_CASE("a draw without bounds keeps six significant digits") {
  CHECK(Round(0.01234567) == 0.0123457);
  CHECK(Round(123456.789) == 123457);
  CHECK(Round(-2.718281828) == -2.71828);
  CHECK(Round(999999.7) == 1e6);
  CHECK(Round(12345678) == 12345700);
  CHECK(Round(0) == 0);
}

TEST_CASE("very small and very large draws keep six significant digits") {
  CHECK(Round(1.23456789e-25) == 1.23457e-25);
  CHECK(Round(-9.87654321e-300) == -9.87654e-300);
  CHECK(Round(1.23456789e40) == 1.23457e40);
  CHECK(Round(4e-324) == 4.9406564584124654e-324);
  CHECK(Round(1.7976931348623157e308) == 1.79769e308);
}

TEST_CASE("a rounded draw is the double nearest to its decimal") {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const std::array<double, 4> u = Uniforms({.index = i}, 1);
    const double value = (u[0] - 0.5) * std::pow(10.0, std::floor(40 * u[1]) - 20);
    const double rounded = Round(value);
    REQUIRE(Digits(rounded) <= 6);
    REQUIRE(std::abs(rounded - value) <= 5.0001e-6 * std::abs(value));
    REQUIRE(Round(rounded) == rounded);
  }
}

TEST_CASE("a draw from a narrow range keeps a millionth of the range") {
  CHECK(RoundWithin(100, 100.001, 100.0001234567) == 100.000123457);
  CHECK(RoundWithin(0.02, 0.03, 0.0234567891) == 0.02345679);
  CHECK(RoundWithin(1000000, 1000001, 1000000.123456) == 1000000.123456);
}

TEST_CASE("a range of a power of ten takes no more digits for its rounding error") {
  // 0.03 - 0.02 is 0.0099999999999999985.
  CHECK(RoundWithin(0.02, 0.03, 0.02000000123) == 0.02);
}

TEST_CASE("a small draw from a wide range keeps its six digits") {
  CHECK(RoundWithin(-1, 1, 1.2345678e-9) == 1.23457e-9);
}

TEST_CASE("a rounded draw is never outside its range nor coarser than a millionth of it") {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const std::array<double, 4> u = Uniforms({.index = i}, 2);
    const double lo = 1e3 * (u[0] - 0.5);
    const double hi = lo + std::pow(10.0, -8 * u[1]) * u[2];
    const double value = std::lerp(lo, hi, u[3]);
    const double rounded = RoundWithin(lo, hi, value);
    REQUIRE(lo <= rounded);
    REQUIRE(rounded <= hi);
    REQUIRE(std::abs(rounded - value) <= 0.5000001e-6 * (hi - lo) + 1e-13);
  }
}

TEST_CASE("rounding that would leave the range stops at its end") {
  CHECK(RoundWithin(0, 0.3333333, 0.33333332) == 0.3333333);
  CHECK(RoundWithin(1, 2, 5) == 2);
  CHECK(RoundWithin(1, 2, -5) == 1);
}

TEST_CASE("a range of one number gives that number to the last digit") {
  CHECK(RoundWithin(0.1234567890123, 0.1234567890123, 0.1234567890123) == 0.1234567890123);
}

TEST_CASE("a range as narrow as doubles allow gives a double of it") {
  const double hi = std::nextafter(1.5, 2.0);
  const double value = RoundWithin(1.5, hi, 1.5);
  CHECK(value == 1.5);
}

TEST_CASE("rounding gives no negative zero") {
  CHECK_FALSE(std::signbit(RoundWithin(-1, 1, -0.0)));
}

}  // namespace
}  // namespace mjforge::sample
