// Rounded numbers, speeds and exceeded limits in messages.
#include "mjforge/expr/rounded_text.h"

#include <catch2/catch.hpp>

namespace mjforge::expr {
namespace {

TEST_CASE("numbers have three digits, and all of those before the point") {
  CHECK(RoundedText(0) == "0");
  CHECK(RoundedText(1.23456) == "1.23");
  CHECK(RoundedText(0.00123456) == "0.00123");
  CHECK(RoundedText(999.6) == "1000");
  CHECK(RoundedText(1501.4) == "1501");
  CHECK(RoundedText(-23456.7) == "-23457");
  CHECK(RoundedText(1.5e12) == "1.5e+12");
}

TEST_CASE("slow speeds are in millimetres") {
  CHECK(SpeedText(0.00082) == "0.82 mm/s");
  CHECK(SpeedText(0.9) == "900 mm/s");
  CHECK(SpeedText(1.2345) == "1.23 m/s");
}

std::string Compared(double value, double limit) {
  const ExceededLimit beyond(value, limit);
  return beyond.value + " " + beyond.limit;
}

TEST_CASE("a number that is beyond a limit is never shown as the limit") {
  CHECK(Compared(201, 100) == "201 100");
  CHECK(Compared(100.04, 100) == "100.04 100");
  CHECK(Compared(99.996, 100) == "99.996 100");
  CHECK(Compared(1004, 1000) == "1004 1000");
  CHECK(Compared(2.34567, 2.34512) == "2.346 2.345");  // both would be 2.35
  CHECK(Compared(3.14159, 1.0 / 3) == "3.14 0.333");
  CHECK(Compared(1, 1) == "1 1");  // not beyond it
}

}  // namespace
}  // namespace mjforge::expr
