// Tests of the conversion of numbers to text and back.
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <random>

#include "harness/effort.h"
#include "mjforge/expr/expr.h"

using namespace mjforge::expr;

namespace {

// The rule that AppendNumber is a faster way to follow.
std::string Reference(double value) {
  std::array<char, 40> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value + 0.0,
                                 std::chars_format::general, 10)
                       .ptr;
  return std::string(buffer.data(), end);
}

double FromText(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

// Counts rather than checks each: a million Catch assertions take a minute.
int Differences(double value) {
  int count = 0;
  for (const double signed_value : {value, -value}) {
    if (NumberText(signed_value) == Reference(signed_value)) continue;
    UNSCOPED_INFO(NumberText(signed_value) << " is not " << Reference(signed_value));
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("a number is written with at most ten digits and no more than it needs") {
  const std::pair<double, std::string> cases[] = {
      {0, "0"},
      {-0.0, "0"},
      {1, "1"},
      {-3, "-3"},
      {0.015, "0.015"},
      {0.1, "0.1"},
      {-0.25, "-0.25"},
      {1.0 / 3, "0.3333333333"},
      {2.0 / 3, "0.6666666667"},
      {3.14159265358979, "3.141592654"},
      {123456.789, "123456.789"},
      {12345678.90625, "12345678.91"},
      {1e-4, "0.0001"},
      {1e-5, "1e-05"},
      {1e-8, "1e-08"},
      {-2.5e-7, "-2.5e-07"},
      {1e-100, "1e-100"},
      {9999999999.0, "9999999999"},
      {1e10, "1e+10"},
      {12345678901.0, "1.23456789e+10"},
      {1e22, "1e+22"},
      {1.5e300, "1.5e+300"},
      {0.99999999999, "1"},
      {0.00099999999999, "0.001"},
      {9.99999999949, "9.999999999"},
      {9.9999999996, "10"},
      {0.1 + 0.2, "0.3"},
      {100, "100"},
      {1200.5, "1200.5"},
  };
  for (const auto& [value, text] : cases) {
    CAPTURE(text);
    CHECK(NumberText(value) == text);
  }
}

TEST_CASE("a number is appended to what is there") {
  std::string text = "size: ";
  AppendNumber(text, 0.5);
  AppendExactNumber(text += ' ', 0.1);
  CHECK(text == "size: 0.5 0.1");
}

TEST_CASE("numbers of all magnitudes are rounded as to_chars rounds them") {
  std::mt19937_64 random(20240607);
  int differences = 0;
  for (int i = 0; i < mjforge::harness::Effort(1'000'000); ++i) {
    const std::uint64_t bits = random();
    const double any = std::bit_cast<double>(bits);
    if (std::isfinite(any)) differences += Differences(any);
    // Magnitudes that models have, from 1e-7 to 1e7.
    const double unit = static_cast<double>(bits >> 11) * 0x1p-53;
    differences += Differences(std::pow(10.0, 14 * unit - 7));
    // Few digits, as people and rounded draws write them.
    differences += Differences(static_cast<double>(bits % 10'000'000) * 1e-6);
    if (differences > 10) break;
  }
  CHECK(differences == 0);
}

TEST_CASE("numbers next to a half of the last digit are rounded as to_chars rounds them") {
  std::mt19937_64 random(7);
  int differences = 0;
  for (int i = 0; i < mjforge::harness::Effort(200'000) && differences <= 10; ++i) {
    const auto digits = static_cast<double>(1'000'000'000 + random() % 9'000'000'000);
    const double value = (digits + 0.5) * std::pow(10.0, static_cast<int>(random() % 20) - 15);
    differences += Differences(value);
    differences += Differences(std::nextafter(value, 0));
    differences += Differences(std::nextafter(value, 1e300));
  }
  CHECK(differences == 0);
}

TEST_CASE("powers of two and ten and their neighbours are rounded as to_chars rounds them") {
  int differences = 0;
  for (int exponent = -1074; exponent < 1024; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    for (const double value : {power, std::nextafter(power, 0), std::nextafter(power, 1e308)}) {
      differences += Differences(value);
    }
  }
  for (int exponent = -320; exponent <= 308; ++exponent) {
    const double power = FromText("1e" + std::to_string(exponent));
    double below = power;
    double above = power;
    for (int step = 0; step < 4; ++step) {
      differences += Differences(below) + Differences(above);
      below = std::nextafter(below, 0);
      above = std::nextafter(above, 1e308);
    }
  }
  CHECK(differences == 0);
}

TEST_CASE("an exact number reads back to the last bit") {
  CHECK(ExactNumberText(0.1) == "0.1");
  CHECK(ExactNumberText(1.0 / 3) == "0.3333333333333333");
  CHECK(ExactNumberText(-3) == "-3");
  CHECK(ExactNumberText(1e300) == "1e+300");
  std::mt19937_64 random(11);
  int differences = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const double back = FromText(ExactNumberText(value));
    if (std::bit_cast<std::uint64_t>(back) != std::bit_cast<std::uint64_t>(value)) ++differences;
  }
  CHECK(differences == 0);
}

TEST_CASE("the numbers of YAML 1.2 are read") {
  const std::pair<std::string, double> cases[] = {
      {"0", 0},
      {"3", 3},
      {"-0.5", -0.5},
      {"+7", 7},
      {"1e-3", 0.001},
      {"1E+3", 1000},
      {"1.e2", 100},
      {".5", 0.5},
      {"-.5e1", -5},
      {"5.", 5},
      {"010", 10},
      {"0x1F", 31},
      {"0xff", 255},
      {"0o17", 15},
      {"0x0", 0},
      {"00.50", 0.5},
      {"1e22", 1e22},
      {"0.1", 0.1},
      {"123456789012345678901234567890", 1.2345678901234568e29},
      {"-0", -0.0},
      {"4.9e-324", 5e-324}};
  for (const auto& [text, value] : cases) {
    CAPTURE(text);
    REQUIRE(ParseNumber(text).has_value());
    CHECK(*ParseNumber(text) == value);
    CHECK(std::signbit(*ParseNumber(text)) == std::signbit(value));
  }
}

TEST_CASE("what is not a number of YAML 1.2 is not read as one") {
  for (const std::string text : {"",
                                 " ",
                                 ".",
                                 "-",
                                 "+",
                                 "e3",
                                 "1e",
                                 "1e+",
                                 ".e3",
                                 "1_000",
                                 "1,5",
                                 "1 ",
                                 " 1",
                                 "--1",
                                 "+-1",
                                 "0x",
                                 "0xg",
                                 "-0x1",
                                 "0o8",
                                 "0o",
                                 "0b1",
                                 ".inf",
                                 "-.inf",
                                 ".nan",
                                 "inf",
                                 "nan",
                                 "infinity",
                                 "NaN",
                                 "1e999",
                                 "-1e999",
                                 "1e-999",
                                 "1.2.3",
                                 "15mm",
                                 "0x1p3",
                                 "true",
                                 "1e3.5",
                                 "0x10000000000000000"}) {
    CAPTURE(text);
    CHECK_FALSE(ParseNumber(text).has_value());
  }
  CHECK_FALSE(ParseNumber(std::string_view("1\0", 2)).has_value());
}
