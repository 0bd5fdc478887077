// Tests of functions that a spec defines.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

SymbolTable NamesWith(const std::vector<SpecFunction>& functions) {
  SymbolTable names;
  names.Declare("r", Type::kNumber);
  names.Declare("kind", Type::kText);
  for (const SpecFunction& function : functions) names.Define(function);
  return names;
}

double ValueOf(std::string_view text, const SymbolTable& names) {
  Error error;
  const auto expression = Expression::Compile(text, names, error);
  INFO(error.message);
  REQUIRE(expression);
  return expression->Evaluate(std::vector<double>{5, 0});
}

Error ErrorOf(std::string_view text, const SymbolTable& names) {
  Error error;
  CHECK_FALSE(Expression::Compile(text, names, error));
  return error;
}

TEST_CASE("a function is its body with the arguments in their places") {
  const SymbolTable names = NamesWith({{"twice", {"x"}, "2 * x"},
                                       {"area", {"a", "b"}, "a * b + r"},
                                       {"both", {"r1"}, "twice(area(r1, r1 + 1))"},
                                       {"is_big", {"x"}, "x > r"}});
  CHECK(ValueOf("twice(3)", names) == 6);
  CHECK(ValueOf("twice(3 - 1) ^ 2", names) == 16);  // not 2 * 3 - 1 ^ 2
  CHECK(ValueOf("area(2, twice(r))", names) == 25);
  CHECK(ValueOf("both(2)", names) == 22);
  CHECK(ValueOf("is_big(6) and not is_big(4)", names) == 1);
  Error error;
  CHECK(Expression::Compile("is_big(6)", names, error)->type() == Type::kBoolean);
  CHECK(Expression::Compile("twice(3)", names, error)->constant() == 6);
}

TEST_CASE("a call with a number is not one with a boolean") {
  const SymbolTable names = NamesWith({{"same", {"x"}, "x"}});
  Error error;
  const auto expression = Expression::Compile("same(1) > 0 ? same(true) : false", names, error);
  REQUIRE(expression);
  CHECK(expression->type() == Type::kBoolean);
}

TEST_CASE("an expression says which functions it calls, and what they read") {
  const SymbolTable names =
      NamesWith({{"f", {"x"}, "x + r"}, {"g", {"x"}, "f(x)"}, {"h", {"x"}, "x"}});
  Error error;
  const auto expression = Expression::Compile("g(1)", names, error);
  REQUIRE(expression);
  CHECK(expression->functions() == std::set<std::string>{"f", "g"});
  REQUIRE(expression->inputs().size() == 1);
  CHECK(expression->inputs()[0].name == "r");
}

TEST_CASE("a fault in a function is at its place there") {
  const SymbolTable names = NamesWith({{"f", {"x"}, "1 + y"}, {"g", {"x"}, "2 * f(x)"}});
  const Error error = ErrorOf("1 + g(2)", names);
  CHECK(error.function == "f");
  CHECK(error.offset == 4);
  CHECK(error.message == "unknown name 'y'");
}

TEST_CASE("calls are checked: their arguments' number and kind, the name") {
  const SymbolTable names = NamesWith({{"area", {"a", "b"}, "a * b"}});
  CHECK(ErrorOf("area(1)", names).message == "'area' takes 2 arguments, not 1");
  CHECK(ErrorOf("area(1)", names).hint == "write area(a, b)");
  CHECK(ErrorOf("area", names).message == "'area' is a function");
  CHECK(ErrorOf("aera(1, 2)", names).hint == "did you mean 'area'?");
  CHECK(ErrorOf("area(kind, 1)", names).message ==
        "'kind' is text; it can only be compared with == or !=");
  CHECK(ErrorOf("area(1, 2", names).message == "'(' is not closed");
}

TEST_CASE("what doubles with each function is not computed twice, and ends") {
  std::vector<SpecFunction> same = {{"f0", {"x"}, "x + r"}};
  std::vector<SpecFunction> other = same;
  for (int i = 1; i < 50; ++i) {
    const std::string call = "f" + std::to_string(i - 1);
    const std::string name = "f" + std::to_string(i);
    same.push_back({name, {"x"}, call + "(x) + " + call + "(x)"});
    other.push_back({name, {"x"}, call + "(2 * x) + " + call + "(3 * x)"});
  }
  CHECK(ValueOf("f49(1)", NamesWith(same)) == 6 * 0x1p49);
  const Error error = ErrorOf("1 + f49(r)", NamesWith(other));
  CHECK(error.message == "the expression calls functions more than 1000 times");
  CHECK(error.function.empty());
  CHECK(error.offset == 4);
}

TEST_CASE("a choice of two texts is a text, where one is wanted") {
  const SymbolTable names = NamesWith({});
  Error error;
  const auto text = Expression::Compile("r > 1 ? 'oak' : r > 0 ? kind : 'pine'", names, error,
                                        Expression::Result::kAny);
  REQUIRE(text);
  CHECK(text->type() == Type::kText);
  CHECK(text->texts() == std::vector<std::string>{"oak", "pine"});
  CHECK(text->Evaluate(std::vector<double>{5, 0}) == TextKey("oak"));
  CHECK(text->Evaluate(std::vector<double>{0.5, TextKey("elm")}) == TextKey("elm"));
  CHECK(ValueOf("(r > 1 ? 'oak' : kind) == 'oak' ? 1 : 2", names) == 1);
  CHECK(ErrorOf("r > 1 ? 'oak' : kind", names).message ==
        "'oak' is text; it can only be compared with == or !=");
  CHECK(ErrorOf("r > 1 ? 'oak' : 2", names).message ==
        "'oak' is text; the other side of the choice is not");
}

}  // namespace
}  // namespace mjforge::expr
