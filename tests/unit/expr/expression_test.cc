// Tests of the values of expressions.
#include <catch2/catch.hpp>
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "mjforge/expr/expr.h"

using namespace mjforge::expr;

namespace {

constexpr double kPi = std::numbers::pi;

// r = 0.25, n = 8, v = (1, 2, 3), uv = (5, 6), yes = true, no = false,
// shape = 'box', other = 'ball', lid.top = 0.5
struct World {
  SymbolTable names;
  std::vector<double> values;

  World() {
    Add("r", Type::kNumber, {0.25});
    Add("n", Type::kNumber, {8});
    Add("v", Type::kNumber, {1, 2, 3});
    Add("uv", Type::kNumber, {5, 6});
    Add("yes", Type::kBoolean, {1});
    Add("no", Type::kBoolean, {0});
    Add("shape", Type::kText, {TextKey("box")});
    Add("other", Type::kText, {TextKey("ball")});
    Add("lid.top", Type::kNumber, {0.5});
  }

  void Add(std::string name, Type type, std::vector<double> components) {
    names.Declare(std::move(name), type, static_cast<int>(components.size()));
    values.insert(values.end(), components.begin(), components.end());
  }
};

Expression Compiled(const std::string& text) {
  Error error;
  auto expression = Expression::Compile(text, World().names, error);
  INFO(text << ": " << error.message << " at " << error.offset);
  REQUIRE(expression.has_value());
  return std::move(*expression);
}

double Value(const std::string& text) { return Compiled(text).Evaluate(World().values); }

void CheckValues(const std::vector<std::pair<std::string, double>>& cases) {
  for (const auto& [text, value] : cases) {
    CAPTURE(text);
    CHECK(Value(text) == value);
  }
}

void CheckTypes(Type type, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    CAPTURE(text);
    CHECK(Compiled(text).type() == type);
  }
}

}  // namespace

TEST_CASE("numbers, names and constants stand for themselves") {
  CheckValues({{"3", 3},
               {"-3", -3},
               {"+.5", 0.5},
               {"1e-3", 1e-3},
               {"0x1F", 31},
               {"010", 10},
               {"r", 0.25},
               {"  n\n", 8},
               {"(r)", 0.25},
               {"((2))", 2},
               {"pi", kPi},
               {"-pi", -kPi},
               {"true", 1},
               {"false", 0},
               {"yes", 1},
               {"v.x", 1},
               {"v.z", 3},
               {"uv.y", 6},
               {"lid.top", 0.5}});
}

TEST_CASE("arithmetic binds as in mathematics") {
  CheckValues({{"1 + 2 * 3", 7},
               {"(1 + 2) * 3", 9},
               {"8 - 3 - 2", 3},
               {"16 / 4 / 2", 2},
               {"2 ^ 3 ^ 2", 512},
               {"-2 ^ 2", -4},
               {"(-2) ^ 2", 4},
               {"2 ^ -1", 0.5},
               {"2 ^ -r", std::pow(2, -0.25)},
               {"-r ^ 2", -0.0625},
               {"- - r", 0.25},
               {"--3", 3},
               {"2 - -3", 5},
               {"2*-r", -0.5},
               {"+r - +r", 0},
               {"7 % 4", 3},
               {"-7 % 4", -3},
               {"7.5 % -2", 1.5},
               {"12 / 4 % 2", 1},
               {"2 * 5 % 3", 1},
               {"5 % 3 * 2", 4},
               {"1 + 7 % 4", 4},
               {"2 * r + 10mm", 2 * 0.25 + 0.01},
               {"r+r*r/r-r", 0.25 + 0.25 * 0.25 / 0.25 - 0.25},
               {"v.x + v.y * v.z", 7}});
}

TEST_CASE("comparisons and logic give 0 and 1") {
  CheckValues({{"1 < 2", 1},
               {"2 < 2", 0},
               {"2 <= 2", 1},
               {"3 > n", 0},
               {"n >= 8", 1},
               {"n == 8", 1},
               {"n != 8", 0},
               {"1 + 1 < 3 * 1", 1},
               {"yes && no", 0},
               {"yes and no", 0},
               {"yes || no", 1},
               {"no or no", 0},
               {"no or yes and no", 0},
               {"yes or yes and no", 1},
               {"(yes or yes) and no", 0},
               {"n > 1 and r < 1", 1},
               {"(1 < 2) == (3 < 4)", 1},
               {"2 && 3", 1},
               {"0 || 0", 0}});
}

TEST_CASE("'!' binds tightly, 'not' looser than comparisons") {
  CheckValues({{"!no", 1},
               {"!yes", 0},
               {"!!n", 1},
               {"not no", 1},
               {"not not yes", 1},
               {"!n == 0", 1},     // (!8) == 0
               {"not n == 0", 1},  // not (8 == 0)
               {"!r < 1", 1},      // (!0.25) < 1
               {"not r < 1", 0},   // not (0.25 < 1)
               {"not no and no", 0},
               {"yes and not no", 1},
               {"!no && !no", 1},
               {"(not yes) == no", 1}});
}

TEST_CASE("a choice takes one of two values and chains to the right") {
  CheckValues({{"yes ? 2 : 3", 2},
               {"no ? 2 : 3", 3},
               {"n > 5 ? r : 2 * r", 0.25},
               {"no ? 1 : no ? 2 : 3", 3},
               {"no ? 1 : yes ? 2 : 3", 2},
               {"yes ? no ? 1 : 2 : 3", 2},
               {"1 + (no ? 1 : 2)", 3},
               {"no or yes ? 1 + 1 : 0", 2},
               {"max(yes ? 1 : 2, 0)", 1},
               {"min(no?1:2,yes?3:4)", 2},
               {"yes ? -r : +r", -0.25}});
}

TEST_CASE("functions compute what their names say") {
  CheckValues({{"abs(-2)", 2},
               {"sin(0.5)", std::sin(0.5)},
               {"cos(r)", std::cos(0.25)},
               {"tan(1)", std::tan(1.0)},
               {"asin(0.5)", std::asin(0.5)},
               {"acos(0.5)", std::acos(0.5)},
               {"atan(2)", std::atan(2.0)},
               {"atan2(1, -1)", 3 * kPi / 4},
               {"sqrt(16)", 4},
               {"exp(1)", std::exp(1.0)},
               {"log(exp(2))", 2},
               {"floor(-1.5)", -2},
               {"ceil(-1.5)", -1},
               {"round(2.5)", 3},
               {"round(-2.5)", -3},
               {"round(2.4)", 2},
               {"sign(-3)", -1},
               {"sign(0)", 0},
               {"sign(r)", 1},
               {"min(3)", 3},
               {"min(3, 1, 2)", 1},
               {"max(3, n, 2, -1)", 8},
               {"clamp(5, 0, 1)", 1},
               {"clamp(-5, 0, 1)", 0},
               {"clamp(r, 0, 1)", 0.25},
               {"lerp(2, 4, r)", 2.5},
               {"lerp(0.1, 0.7, 1)", 0.7},
               {"lerp(0.1, 0.7, 0)", 0.1},
               {"sqrt(v.x * v.x + v.y * v.y)", std::sqrt(5.0)},
               {"max(min(1, 2), sin(0) + min(n, 3)) * 2", 6}});
}

TEST_CASE("texts compare with quoted literals and with each other") {
  CheckValues({{"shape == 'box'", 1},
               {"shape == \"box\"", 1},
               {"shape != 'box'", 0},
               {"'box' == shape", 1},
               {"shape == 'ball'", 0},
               {"shape == other", 0},
               {"shape != other", 1},
               {"'a' == 'a'", 1},
               {"shape == ''", 0},
               {"(shape) == ('box')", 1},
               {"shape == 'box' and n > 2", 1},
               {"not shape == 'box'", 0},
               {"shape == 'ball' ? 1 : 2", 2},
               {"other == \"it's\"", 0}});
}

TEST_CASE("not a number is passed on, never swallowed") {
  for (const std::string text : {"0 / 0", "sqrt(-1)", "max(1, 0 / 0)", "max(0 / 0, 1)",
                                 "min(0 / 0, 1)", "min(1, sqrt(-1), 2)", "clamp(0 / 0, 0, 1)",
                                 "sign(0 / 0)", "1 % 0", "r + 0 / 0", "acos(2)", "(-1) ^ 0.5"}) {
    CAPTURE(text);
    CHECK(std::isnan(Value(text)));
  }
  CHECK(Value("1 / 0") == std::numeric_limits<double>::infinity());
  CHECK(Value("log(0)") == -std::numeric_limits<double>::infinity());
  CHECK(Compiled("1 / 0").constant().has_value());
}

TEST_CASE("comparisons and logic are boolean, all else is a number") {
  CheckTypes(Type::kBoolean,
             {"true", "yes", "(yes)", "1 < 2", "not n", "!n", "yes and n", "shape == 'box'",
              "n > 1 ? yes : no", "(n == 1)", "n > 1 ? true : n > 0"});
  CheckTypes(Type::kNumber, {"1", "n", "-yes", "+yes", "yes + no", "(n > 1) * 2", "yes ? 1 : 2",
                             "yes ? yes : 2", "max(yes, no)", "pi", "15mm"});
}

TEST_CASE("inputs are listed once, in the order of first use, as written") {
  const Expression expression = Compiled("v.y + r * v.y + (shape == 'box') + lid.top");
  REQUIRE(expression.inputs().size() == 4);
  CHECK(expression.inputs()[0].name == "v.y");
  CHECK(expression.inputs()[0].slot == 3);
  CHECK(expression.inputs()[1].name == "r");
  CHECK(expression.inputs()[2].name == "shape");
  CHECK(expression.inputs()[2].type == Type::kText);
  CHECK(expression.inputs()[3].name == "lid.top");
  CHECK(expression.text() == "v.y + r * v.y + (shape == 'box') + lid.top");
  CHECK_FALSE(expression.constant().has_value());
}

TEST_CASE("an expression without inputs is a constant") {
  CHECK(Compiled("2 * 15mm").constant() == 0.03);
  CHECK(Compiled("-3").constant() == -3);
  CHECK(Compiled("max(1, 2) < 3").constant() == 1);
  CHECK(Compiled("15mm").inputs().empty());
  CHECK(Compiled("pi").constant() == kPi);
}

TEST_CASE("an expression moves with all it owns and follows its variables") {
  World world;
  Error error;
  std::vector<Expression> expressions;
  for (int i = 0; i < 50; ++i) {
    const std::string text = "r * " + std::to_string(i) + " + n";
    expressions.push_back(std::move(*Expression::Compile(text, world.names, error)));
  }
  world.values[0] = 2;
  for (int i = 0; i < 50; ++i) {
    CHECK(expressions[static_cast<std::size_t>(i)].Evaluate(world.values) == 2 * i + 8);
  }
  world.values[1] = 0;
  CHECK(expressions[3].Evaluate(world.values) == 6);
}

TEST_CASE("sums and products are computed in the order they are written") {
  std::mt19937 random(3);
  SymbolTable names;
  std::vector<double> values(4);
  for (const char* name : {"a", "b", "c", "d"}) names.Declare(name, Type::kNumber);
  Error error;
  const auto sum = Expression::Compile("a + 0.1 + b + 0.2 - c + d + a", names, error);
  const auto product = Expression::Compile("a * 0.3 * b * 3 / c * d + 0.7 * a * 3", names, error);
  REQUIRE(sum.has_value());
  REQUIRE(product.has_value());
  for (int i = 0; i < 1000; ++i) {
    for (double& value : values) value = static_cast<double>(random()) * 1e-6 + 1e-3;
    const double a = values[0], b = values[1], c = values[2], d = values[3];
    CHECK(sum->Evaluate(values) == a + 0.1 + b + 0.2 - c + d + a);
    CHECK(product->Evaluate(values) == a * 0.3 * b * 3 / c * d + 0.7 * a * 3);
  }
}

TEST_CASE("a forgotten name's slots stay with the expressions that used it") {
  SymbolTable names;
  Error error;
  names.Declare("i", Type::kNumber);
  const auto first = Expression::Compile("i + 1", names, error);
  names.Forget("i");
  names.Declare("i", Type::kNumber);
  const auto second = Expression::Compile("i + 1", names, error);
  const std::vector<double> values = {10, 20};
  CHECK(first->Evaluate(values) == 11);
  CHECK(second->Evaluate(values) == 21);
}

TEST_CASE("a long sum of parts is computed") {
  std::string text = "n";
  for (int i = 0; i < 1500; ++i) text += " + r";
  CHECK(Value(text) == 8 + 1500 * 0.25);
  std::string maximum = "max(0";
  for (int i = 0; i < 500; ++i) maximum += ", " + std::to_string(i);
  CHECK(Value(maximum + ")") == 499);
}

TEST_CASE("parentheses may be nested to a depth nobody needs") {
  CHECK(Value(std::string(190, '(') + "r" + std::string(190, ')')) == 0.25);
  CHECK(Value(std::string(190, '-') + "r") == 0.25);
}

namespace {

// Decimal commas and dots between thousands, as in Germany; unlike the system's
// locales it is there on every machine.
class GermanNumbers : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

void CheckNumbersOfTheLanguage() {
  CHECK(NumberText(1234.5) == "1234.5");
  CHECK(NumberText(1e-8) == "1e-08");
  CHECK(ExactNumberText(0.5) == "0.5");
  CHECK(ParseNumber("1.5") == 1.5);
  CHECK(Value("1234.5 * n + max(0.5, 0.25)") == 9876.5);
  CHECK(Value("15.5mm") == 0.0155);
}

}  // namespace

TEST_CASE("the locale of C++ changes no number") {
  const std::locale before = std::locale::global(std::locale(std::locale(), new GermanNumbers));
  CheckNumbersOfTheLanguage();
  std::locale::global(before);
}

TEST_CASE("the locale of C changes no number") {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  // Whichever of these the machine has; the C locale is there in any case.
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) {
    if (std::setlocale(LC_ALL, name) == nullptr) continue;
    CAPTURE(name);
    CheckNumbersOfTheLanguage();
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("an expression may have as many parts as its text has room for") {
  std::string sum = "r";
  for (int i = 0; i < 4990; ++i) sum += "+r";
  CHECK(Value(sum) == 4991 * 0.25);
}

TEST_CASE("zero and minus zero are different constants") {
  CHECK(std::isnan(Value("1 / (r * 0) + 1 / (r * -0)")));
  CHECK(Value("1 / (r * 0) + 1 / (r * 0)") == std::numeric_limits<double>::infinity());
}

TEST_CASE("a copy of an expression is evaluated apart from the original") {
  const Expression original = Compiled("r * n");
  const Expression copy = original;
  std::vector<double> others = World().values;
  others[0] = 1;
  CHECK(copy.Evaluate(others) == 8);
  CHECK(original.Evaluate(World().values) == 2);
}
