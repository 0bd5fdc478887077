// Tests of the list of built-in functions and constants.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "mjforge/expr/expr.h"

using namespace mjforge::expr;

TEST_CASE("the functions are listed in order, each with its use and an explanation") {
  const auto functions = Builtins();
  CHECK(functions.size() == 26);
  CHECK(std::is_sorted(functions.begin(), functions.end(),
                       [](const BuiltinInfo& a, const BuiltinInfo& b) { return a.name < b.name; }));
  for (const BuiltinInfo& function : functions) {
    CAPTURE(function.name);
    CHECK(function.usage.substr(0, function.name.size()) == function.name);
    CHECK_FALSE(function.doc.empty());
  }
}

TEST_CASE("every function that is listed works as its use shows") {
  SymbolTable names;
  for (const char* name : {"x", "y", "a", "b", "t", "lo", "hi"}) {
    names.Declare(name, Type::kNumber);
  }
  for (const char* site : {"a", "b"}) names.Declare(PositionVariable(site), Type::kNumber, 3);
  names.Declare(TorqueVariable("joint"), Type::kNumber);
  names.DeclareList("list", Type::kNumber);
  names.Declare("n", Type::kNumber);
  for (const BuiltinInfo& function : Builtins()) {
    std::string usage(function.usage);
    if (const auto dots = usage.find("..."); dots != std::string::npos) usage.replace(dots, 3, "y");
    CAPTURE(usage);
    Error error;
    CHECK(Expression::Compile(usage, names, error).has_value());
    CHECK(error.message.empty());
  }
}
