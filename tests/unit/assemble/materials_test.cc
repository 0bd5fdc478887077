// Tests of materials: use, draws, sharing.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

TEST_CASE("only materials in use that have a look are kept") {
  const Assembling thing(
      "materials:\n"
      "  red: {rgba: [1, 0, 0, 1], density: 500}\n"
      "  green: {rgba: [0, 1, 0, 1]}\n"
      "  heavy: {density: 9000}\n"
      "parts:\n"
      "- {name: a, type: sphere, size: [1], material: heavy}\n"
      "- {name: b, type: sphere, size: [1], material: red}\n"
      "- {name: c, type: sphere, size: [1], material: red}\n");
  REQUIRE(thing.object().materials.size() == 1);
  CHECK(thing.object().materials[0].name == "thing_red");
  CHECK(model::FindAttribute(thing.object().materials[0].attributes, "rgba")->numbers ==
        sample::Numbers{1, 0, 0, 1});
  CHECK(thing.part("thing_a").material == -1);
  CHECK(thing.part("thing_b").material == 0);
  CHECK(thing.part("thing_c").material == 0);
}

TEST_CASE("what is drawn in a material is the same for all its parts") {
  const Assembling thing(
      "materials: {wood: {density: 400 .. 900, friction: 1 .. 2}}\n"
      "parts:\n"
      "- {name: a, type: sphere, size: [1], material: wood}\n"
      "- {name: b, type: sphere, size: [2], material: wood}\n");
  const model::Part& a = thing.part("thing_a");
  const model::Part& b = thing.part("thing_b");
  CHECK(a.density == b.density);
  CHECK(model::FindAttribute(a.attributes, "friction")->numbers ==
        model::FindAttribute(b.attributes, "friction")->numbers);
  sample::StreamId path = sample::kRootStream;
  for (const char* step : {"thing", "materials", "wood", "density"})
    path = sample::Child(path, step);
  const double u = sample::Uniforms({.seed = 1, .index = 0}, path)[0];
  CHECK(a.density == sample::RoundWithin(400, 900, 400 + u * 500));
}

TEST_CASE("a material chosen by a parameter must exist") {
  CHECK(OnlyFinding("params: {m: {choice: [steal]}}\n"
                    "materials: {steel: {density: 7800}}\n"
                    "parts: [{name: a, type: sphere, size: [1], material: '${m}'}]\n") ==
        "5:54 no material 'steal' (did you mean 'steel'?)");
}

TEST_CASE("a material's numbers are checked once") {
  CHECK(OnlyFinding("params: {x: 2}\n"
                    "materials: {red: {rgba: [x, 0, 0, 1]}}\n"
                    "parts:\n"
                    "- {name: a, type: sphere, size: [1], material: red}\n"
                    "- {name: b, type: sphere, size: [1], material: red}\n") ==
        "4:26 rgba 1 of material 'red' is 2; it must be at most 1 (it is the value of 'x')");
}

}  // namespace
}  // namespace mjforge::assemble
