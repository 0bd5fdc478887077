// Tests of dimensional analysis and of the names of units.
#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/expr/expr.h"

using namespace mjforge::expr;
using mjforge::diag::Code;

namespace {

constexpr Dimension kLength = {1, 0, 0};
constexpr Dimension kMass = {0, 1, 0};
constexpr Dimension kAngle = {0, 0, 0, 1};

SymbolTable Quantities() {
  SymbolTable names;
  names.Declare("w", Type::kNumber, 1, {kLength});
  names.Declare("h", Type::kNumber, 1, {kLength});
  names.Declare("load", Type::kNumber, 1, {kMass});
  names.Declare("turn", Type::kNumber, 1, {kAngle});
  names.Declare("n", Type::kNumber, 1, {Dimension::Count()});
  names.Declare("any", Type::kNumber);
  names.Declare("polar", Type::kNumber, 2, {kLength, kAngle});
  names.Declare("size", Type::kNumber, 3, {kLength});
  names.DeclareList("widths", Type::kNumber, {kLength});
  names.Declare("is_on", Type::kBoolean);
  names.Define({.name = "area", .arguments = {"a", "b"}, .body = "a * b"});
  names.Define({.name = "longer", .arguments = {"a"}, .body = "a + 1cm"});
  return names;
}

// "unknown" where nothing is known.
std::string UnitOf(const std::string& text) {
  Error error;
  const auto expression = Expression::Compile(text, Quantities(), error);
  if (!expression) return error.message;
  const Dimension& dimension = expression->dimension();
  return dimension.is_known() ? dimension.Text() : "unknown";
}

}  // namespace

TEST_CASE("what an expression measures follows from its parts") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"15mm", "m"},
      {"90deg", "rad"},
      {"700", "unknown"},
      {"2", "1"},
      {"2 * w", "m"},
      {"w / 2 + 1cm", "m"},
      {"w + 0.3", "m"},
      {"0.3 + w", "m"},
      {"0.9 * w", "unknown"},
      {"0.5 * w", "m"},
      {"any * w", "unknown"},
      {"any + w", "m"},
      {"n * w", "m"},
      {"w * h", "m^2"},
      {"pi * w ^ 2 * h", "m^3"},
      {"load / (w * h * h)", "kg/m^3"},
      {"w / h", "1"},
      {"w / h * load", "kg"},
      {"sqrt(w ^ 2 + h ^ 2)", "m"},
      {"sqrt(w)", "unknown"},
      {"(w * h * h) ^ (1 / 3)", "m"},
      {"w ^ n", "unknown"},
      {"(w / h) ^ n", "1"},
      {"w ^ 1000", "unknown"},
      {"w ^ -1", "1/m"},
      {"-w", "m"},
      {"+w", "m"},
      {"w % h", "m"},
      {"abs(w)", "m"},
      {"max(w, h, 0)", "m"},
      {"min(widths)", "m"},
      {"max(widths, 3cm)", "m"},
      {"sum(widths)", "m"},
      {"sum(widths, n)", "m"},
      {"len(widths)", "1"},
      {"widths[n]", "m"},
      {"size[n]", "m"},
      {"size[1]", "m"},
      {"size.x", "m"},
      {"polar.x", "m"},
      {"polar.y", "rad"},
      {"polar[1]", "rad"},
      {"polar[n]", "unknown"},
      {"clamp(w, 1cm, 3cm)", "m"},
      {"lerp(w, h, 0.3)", "m"},
      {"sin(turn)", "1"},
      {"w * sin(turn)", "m"},
      {"w * turn", "m"},
      {"turn * w", "m"},
      {"2 * turn", "rad"},
      {"turn / turn", "1"},
      {"turn * turn", "1"},
      {"turn / 1s", "1/s"},
      {"1 / turn", "1"},
      {"1 - turn ^ 2 / 2", "1"},
      {"360deg / n", "rad"},
      {"atan2(w, h)", "rad"},
      {"asin(w / h)", "rad"},
      {"round(w / h)", "1"},
      {"is_on ? w : 0", "m"},
      {"is_on ? 0 : w", "m"},
      {"is_on * w", "m"},
      {"w < h", "1"},
      {"5N", "N"},
      {"5Nm / w", "N"},
      {"5N * w", "Nm"},
      {"5N / w", "N/m"},
      {"5N * 1s / w", "Ns/m"},
      {"5Nm * 1s / 1rad", "Nms"},
      {"load * w / 1s / 1s", "N"},
      {"load * w ^ 2 / 1s ^ 3", "kg m^2/s^3"},
      {"load / w / 1s", "kg/m/s"},
      {"area(w, h)", "m^2"},
      {"area(load, 2)", "kg"},
      {"longer(w)", "m"},
  };
  for (const auto& [text, unit] : cases) {
    CAPTURE(text);
    CHECK(UnitOf(text) == unit);
  }
}

TEST_CASE("units that do not fit are told with both sides, at the sign") {
  struct Case {
    std::string text;
    std::size_t offset;
    std::string message;
    std::string hint;
  };
  const std::vector<Case> cases = {
      {"15mm + 2kg", 5, "'15mm' is in m, but '2kg' is in kg",
       "both sides of '+' must be in one unit"},
      {"w - load", 2, "'w' is in m, but 'load' is in kg", "both sides of '-' must be in one unit"},
      {"2 * w + 3 * load", 6, "'2 * w' is in m, but '3 * load' is in kg",
       "both sides of '+' must be in one unit"},
      {"w * h > load", 6, "'w * h' is in m^2, but 'load' is in kg",
       "both sides of '>' must be in one unit"},
      {"w == turn", 2, "'w' is in m, but 'turn' is in rad",
       "both sides of '==' must be in one unit"},
      {"is_on ? w : load", 10, "'w' is in m, but 'load' is in kg",
       "both sides of ':' must be in one unit"},
      {"max(0, w, load)", 0, "'w' is in m, but 'load' is in kg",
       "the arguments of 'max' must be in one unit"},
      {"max(widths, load)", 0, "'widths' is in m, but 'load' is in kg",
       "the arguments of 'max' must be in one unit"},
      {"1 + clamp(w, 1kg, 3)", 4, "'w' is in m, but '1kg' is in kg",
       "the arguments of 'clamp' must be in one unit"},
      {"sin(w)", 0, "'w' is in m, but 'sin' takes an angle in rad", ""},
      {"acos(w)", 0, "'w' is in m, but what 'acos' takes is a plain number", ""},
      {"exp(load)", 0, "'load' is in kg, but what 'exp' takes is a plain number", ""},
      {"2 ^ w", 2, "'w' is in m, but an exponent is a plain number", ""},
      {"lerp(w, h, h)", 0, "'h' is in m, but the last argument of 'lerp' is a plain number", ""},
      {"widths[w]", 0, "'w' is in m, but the number of a value in a list is a plain number", ""},
      {"sum(widths, w)", 4, "'w' is in m, but how many to add is a plain number", ""},
      {"w + (load + load + load + load + load + load + load)", 2,
       "'w' is in m, but the other is in kg", "both sides of '+' must be in one unit"},
      {"longer(load)", 2, "'a' is in kg, but '1cm' is in m",
       "both sides of '+' must be in one unit"},
  };
  for (const Case& each : cases) {
    CAPTURE(each.text);
    Error error;
    CHECK_FALSE(Expression::Compile(each.text, Quantities(), error).has_value());
    CHECK(CodeName(error.code) == CodeName(Code::kExprUnits));
    CHECK(error.offset == each.offset);
    CHECK(error.message == each.message);
    CHECK(error.hint == each.hint);
  }
}

TEST_CASE("the name of a unit says what it measures, and whether it is of SI") {
  const auto text = [](std::string_view unit) {
    const auto found = FindUnit(unit);
    return found ? found->dimension.Text() + (found->is_si ? "" : " (not SI)") : "none";
  };
  CHECK(text("m") == "m");
  CHECK(text("mm") == "m (not SI)");
  CHECK(text("deg") == "rad (not SI)");
  CHECK(text("1") == "1");
  CHECK(text("kg/m^3") == "kg/m^3");
  CHECK(text("g/cm^3") == "kg/m^3 (not SI)");
  CHECK(text("kg*m^2") == "kg m^2");
  CHECK(text("kg m^2") == "kg m^2");
  CHECK(text("Nms/rad") == "Nms");
  CHECK(text("Nm/rad") == "Nm");
  CHECK(text("N/m") == "N/m");
  CHECK(text("rad/s") == "1/s");
  CHECK(text("m/s^2") == "m/s^2");
  CHECK(text("m^-1") == "1/m");
  for (const char* label : {"", "books", "m^", "m^x", "/m", "m/", "m//s", "m^99999999999", " m"}) {
    CAPTURE(label);
    CHECK(text(label) == "none");
  }
}
