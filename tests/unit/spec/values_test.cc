#include "mjforge/spec/values.h"

#include <catch2/catch.hpp>

#include "loading.h"

namespace mjforge::spec {
namespace {

bool Draws(const std::string& rgba) {
  const Loaded loaded = LoadWithBox("materials: {m: {rgba: " + rgba + "}}");
  REQUIRE(loaded.Report().empty());
  return HasDraw(loaded.spec->materials.at(0).fields.at(0).value);
}

TEST_CASE("a value draws if any number in it is drawn", "[values]") {
  CHECK(Draws("[0 .. 1, 0, 0, 1]"));
  CHECK(Draws("{choice: [[1, 0, 0, 1], [0, 1, 0, 1]]}"));
  CHECK(Draws("{hsv: [0 .. 1, 1, 1]}"));
  CHECK_FALSE(Draws("{hsv: [0.3, 1, 1]}"));
  CHECK_FALSE(Draws("[1, 0, 0, 1]"));
}

}  // namespace
}  // namespace mjforge::spec
