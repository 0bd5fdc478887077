// Tests of the names used in an expression.
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "mjforge/expr/expr.h"

using mjforge::expr::NamesUsedIn;
using List = std::vector<std::string>;

TEST_CASE("the names of an expression come in the order of first use, once each") {
  CHECK(NamesUsedIn("b + a * b - c") == List{"b", "a", "c"});
  CHECK(NamesUsedIn("r") == List{"r"});
  CHECK(NamesUsedIn("2 * 3mm").empty());
  CHECK(NamesUsedIn("").empty());
}

TEST_CASE("functions, constants, keywords, units and texts are no names") {
  CHECK(NamesUsedIn("max(a, pi) + sin(b)") == List{"a", "b"});
  CHECK(NamesUsedIn("not a and b or true") == List{"a", "b"});
  CHECK(NamesUsedIn("15mm + 90deg * x1") == List{"x1"});
  CHECK(NamesUsedIn("shape == 'box'") == List{"shape"});
  CHECK(NamesUsedIn("shape == \"it is x\"") == List{"shape"});
}

TEST_CASE("vectors are named without their component, other dotted names whole") {
  CHECK(NamesUsedIn("size.x + size.y") == List{"size"});
  CHECK(NamesUsedIn("lid.top - lid.half_x") == List{"lid.top", "lid.half_x"});
  CHECK(NamesUsedIn("lid.size.z") == List{"lid.size"});
}

TEST_CASE("names are found on both sides of a range and in what does not compile") {
  CHECK(NamesUsedIn("a .. 1.2 * b") == List{"a", "b"});
  CHECK(NamesUsedIn("a..b") == List{"a", "b"});
  CHECK(NamesUsedIn("1..n") == List{"n"});
  CHECK(NamesUsedIn("a b )") == List{"a", "b"});
}

TEST_CASE("a text that is no sequence of words has no names") {
  CHECK(NamesUsedIn("wall_${i}").empty());
  CHECK(NamesUsedIn("don't").empty());
  CHECK(NamesUsedIn("a # b").empty());
  CHECK(NamesUsedIn(std::string("a\0b", 3)).empty());
}
