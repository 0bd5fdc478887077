// Tests of the values of records as columns.

#include <catch2/catch.hpp>

#include <bit>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

TEST_CASE("members of records are columns, with a value for each row") {
  Columns columns({"a", "b", "none"});
  REQUIRE(columns.Add(R"({"a": 1, "b": {"x": 0.1, "y": "u"}, "c": 7})"));
  REQUIRE(columns.Add(R"({"b": {"y": "w", "z": [true]}, "a": 18446744073709551615})"));
  REQUIRE(columns.Add(R"({"a": null, "b": {"y": "u", "z": [false, -2]}})"));
  const std::vector<Column>& made = columns.Finish();

  REQUIRE(made.size() == 3);
  CHECK(columns.rows() == 3);
  CHECK(made[0].kinds == "iu ");
  CHECK(made[0].values == std::vector<std::uint64_t>{1, 18446744073709551615U, 0});
  CHECK(made[1].kinds == "ooo");
  CHECK(made[2].kinds == "   ");
  const std::vector<Column>& inner = made[1].inner;
  REQUIRE(inner.size() == 3);
  CHECK(inner[0].key == "x");
  CHECK(inner[0].kinds == "f  ");
  CHECK(std::bit_cast<double>(inner[0].values[0]) == 0.1);
  CHECK(inner[1].kinds == "ttt");
  CHECK(inner[1].values == std::vector<std::uint64_t>{0, 1, 0});
  CHECK(columns.texts() == std::vector<std::string>{"u", "w"});
  CHECK(inner[2].kinds == " ll");
  CHECK(inner[2].values == std::vector<std::uint64_t>{0, 1, 2});
  REQUIRE(inner[2].inner.size() == 2);
  CHECK(inner[2].inner[0].kinds == " bb");
  CHECK(inner[2].inner[1].kinds == "  i");
  CHECK(std::bit_cast<std::int64_t>(inner[2].inner[1].values[2]) == -2);
}

TEST_CASE("a text that is not an object is no row") {
  Columns columns({"a"});
  for (const char* text : {"", "[1]", "{\"a\": 1", "{} {}"}) CHECK_FALSE(columns.Add(text));
  CHECK(columns.rows() == 0);
  CHECK(columns.Finish()[0].kinds.empty());
}

}  // namespace
}  // namespace mjforge::manifest
