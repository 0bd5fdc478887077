// Tests of units after numbers.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>
#include <string>

#include "mjforge/expr/expr.h"

using namespace mjforge::expr;

namespace {

double ConstantOf(const std::string& text) {
  Error error;
  const auto expression = Expression::Compile(text, SymbolTable(), error);
  REQUIRE(expression.has_value());
  REQUIRE(expression->constant().has_value());
  return *expression->constant();
}

}  // namespace

TEST_CASE("units convert to SI and the result is the nearest double") {
  CHECK(ConstantOf("15mm") == 0.015);
  CHECK(ConstantOf("3cm") == 0.03);
  CHECK(ConstantOf("7um") == 7e-6);
  CHECK(ConstantOf("1.5km") == 1500);
  CHECK(ConstantOf("2m") == 2);
  CHECK(ConstantOf("250g") == 0.25);
  CHECK(ConstantOf("3kg") == 3);
  CHECK(ConstantOf("20ms") == 0.02);
  CHECK(ConstantOf("4s") == 4);
  CHECK(ConstantOf("90deg") == std::numbers::pi / 2);
  CHECK(ConstantOf("180deg") == std::numbers::pi);
  CHECK(ConstantOf("1.5rad") == 1.5);
  CHECK(ConstantOf("8N") == 8);
  CHECK(ConstantOf("9Nm") == 9);
  for (int i = 1; i < 1000; ++i) {
    CAPTURE(i);
    CHECK(ConstantOf(std::to_string(i) + "mm") == i / 1000.0);
  }
}

TEST_CASE("a unit follows any spelling of a number") {
  CHECK(ConstantOf("1e3mm") == 1);
  CHECK(ConstantOf("5.mm") == 0.005);
  CHECK(ConstantOf(".5m") == 0.5);
  CHECK(ConstantOf("2e-1cm") == 0.002);
  CHECK(ConstantOf("-10mm") == -0.01);
  CHECK(ConstantOf("0x10mm") == 0.016);
}

TEST_CASE("the units are listed, lengths first, each with an explanation") {
  const auto units = Units();
  REQUIRE(units.size() == 13);
  CHECK(units.front().name == "mm");
  for (const Unit& unit : units) {
    CAPTURE(unit.name);
    CHECK_FALSE(unit.doc.empty());
    CHECK(ConstantOf("1" + std::string(unit.name)) > 0);
  }
}
