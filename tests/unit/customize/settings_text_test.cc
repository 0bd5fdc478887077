#include "mjforge/customize/settings_text.h"

#include <catch2/catch.hpp>

namespace mjforge::customize {
namespace {

TEST_CASE("a text is quoted for YAML only if it would be read as something else") {
  CHECK(QuoteForYaml("cylinder") == "cylinder");
  CHECK(QuoteForYaml("M3") == "M3");
  CHECK(QuoteForYaml("no") == "'no'");
  CHECK(QuoteForYaml("True") == "'True'");
  CHECK(QuoteForYaml("") == "''");
  CHECK(QuoteForYaml("3") == "'3'");
  CHECK(QuoteForYaml("it's: [a]") == "'it''s: [a]'");
}

TEST_CASE("a text is an expression that YAML reads as one value") {
  CHECK(LiteralForYaml("pi") == "${'pi'}");
  CHECK(LiteralForYaml("a + b") == "${'a + b'}");
  CHECK(LiteralForYaml("") == "${''}");
  CHECK(LiteralForYaml("x: y") == "'${''x: y''}'");
  CHECK(LiteralForYaml("it's") == "'${''''}it''s'");
  CHECK(LiteralForYaml("${x}") == "'${''''}${''$''}{x}'");
}

TEST_CASE("the command names what is not the default") {
  const std::vector<spec::Setting> settings = {{"length", "0.25"}, {"size", "[1, 2]"}};
  CHECK(CommandText("hammer", {}, {}) == "mjforge generate hammer");
  CHECK(CommandText("tools/hammer", {}, {.index = 2, .place_seed = 4}, 10, "hammer") ==
        "mjforge generate tools/hammer --place-seed 4 --first 2 -n 10 -o hammer/");
  CHECK(
      CommandText("my lamp.yaml", settings, {.seed = 7, .index = 41}) ==
      "mjforge generate 'my lamp.yaml' --seed 7 --first 41 --set length=0.25 --set 'size=[1, 2]'");
}

TEST_CASE("settings are a YAML mapping") {
  const std::vector<spec::Setting> settings = {{"length", "0.25"}, {"size", "[1, 2]"}};
  CHECK(ParamsText(settings) == "length: 0.25\nsize: [1, 2]\n");
  CHECK(ParamsText({}) == "{}\n");
}

}  // namespace
}  // namespace mjforge::customize
