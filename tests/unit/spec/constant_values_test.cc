#include <catch2/catch.hpp>

#include "loading.h"

namespace {

using mjforge::spec::ConstantValue;

// The constant value of a part's last field; nullopt if the field has none.
std::optional<ConstantValue> ConstantOf(const std::string& field) {
  const Loaded loaded = Load(
      "mjforge: 1\nname: t\nparams: {r: 0.1 .. 0.2, look: {choice: [box, sphere]}}\n"
      "parts: [{name: a, " +
      field + "}]\n");
  if (loaded.spec == nullptr) return std::nullopt;
  const auto& constant = loaded.spec->parts[0].fields.back().constant;
  return constant ? std::optional(*constant) : std::nullopt;
}

}  // namespace

TEST_CASE("a field without variables has its numbers and their text", "[constants]") {
  const auto friction = ConstantOf("type: box, size: [r, r, r], friction: [1, 5e-3, 1/3]");
  REQUIRE(friction);
  CHECK(friction->numbers == std::vector{1.0, 5e-3, 1.0 / 3});
  CHECK(friction->text == "1 0.005 0.3333333333");
  const auto euler = ConstantOf("type: box, size: [r, r, r], euler: [0, 180deg, 0]");
  REQUIRE(euler);
  CHECK(euler->text == "0 3.141592654 0");
  const auto condim = ConstantOf("type: box, size: [r, r, r], condim: 4");
  REQUIRE(condim);
  CHECK(condim->numbers == std::vector{4.0});
  CHECK(condim->text == "4");
}

TEST_CASE("a word without variables is constant, too", "[constants]") {
  const auto type = ConstantOf("size: [r, r, r], type: box");
  REQUIRE(type);
  CHECK(type->numbers.empty());
  CHECK(type->text == "box");
}

TEST_CASE("a field that differs between variants has no constant value", "[constants]") {
  CHECK_FALSE(ConstantOf("type: box, size: [1, 1, r]"));
  CHECK_FALSE(ConstantOf("type: box, size: [1, 1, 1 .. 2]"));
  CHECK_FALSE(ConstantOf("type: box, size: 1, pos: {choice: [[0, 0, 0], [1, 0, 0]]}"));
  CHECK_FALSE(ConstantOf("size: 1, type: '${look}'"));
}
