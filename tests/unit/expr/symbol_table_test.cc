// Tests of the symbol table of expressions.
#include <catch2/catch.hpp>

#include "mjforge/expr/expr.h"

using namespace mjforge::expr;

TEST_CASE("each name gets slots of its own, a vector one for each component") {
  SymbolTable names;
  CHECK(names.Declare("index", Type::kNumber).slot == 0);
  CHECK(names.Declare("size", Type::kNumber, 3).slot == 1);
  CHECK(names.Declare("shape", Type::kText).slot == 4);
  CHECK(names.slot_count() == 5);
  REQUIRE(names.Find("size") != nullptr);
  CHECK(names.Find("size")->components == 3);
  CHECK(names.Find("shape")->type == Type::kText);
  CHECK(names.Find("siz") == nullptr);
  CHECK(names.variables().size() == 3);
}

TEST_CASE("a forgotten name leaves a hole and can be declared anew") {
  SymbolTable names;
  names.Declare("i", Type::kNumber);
  names.Declare("r", Type::kNumber);
  names.Forget("i");
  CHECK(names.Find("i") == nullptr);
  CHECK(names.Find("r")->slot == 1);
  CHECK(names.slot_count() == 2);
  CHECK(names.Declare("i", Type::kBoolean).slot == 2);
  names.Forget("nobody");
  CHECK(names.variables().size() == 2);
}

TEST_CASE("types have names for messages") {
  CHECK(TypeName(Type::kNumber) == "number");
  CHECK(TypeName(Type::kBoolean) == "boolean");
  CHECK(TypeName(Type::kText) == "text");
}

TEST_CASE("a name is a letter, then letters, digits and underscores") {
  for (const std::string_view name : {"a", "Z9", "wall_3_"}) CHECK(IsName(name));
  for (const std::string_view text : {"", "_a", "9a", "a-b", "a b", "caf\xc3\xa9"}) {
    INFO(text);
    CHECK_FALSE(IsName(text));
  }
}

TEST_CASE("words stand between blanks") {
  using Words = std::vector<std::string_view>;
  CHECK(WordsOf("box sphere") == Words{"box", "sphere"});
  CHECK(WordsOf("\t 1\n 2  ") == Words{"1", "2"});
  CHECK(WordsOf(" \r\n").empty());
}
