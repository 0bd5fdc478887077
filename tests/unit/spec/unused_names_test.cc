#include <catch2/catch.hpp>

#include "loading.h"

TEST_CASE("a parameter that nothing uses is a warning at its name", "[unused]") {
  CHECK(LoadWithBox("params:\n  used: 1\n  idle: 1 .. 2\nrequire: used > 0\n").Unused() ==
        Strings{"6:3 parameter 'idle' is never used"});
}

TEST_CASE("a parameter is used wherever its name is read", "[unused]") {
  const char* uses[] = {
      "require: p > 0",
      "mass: p",
      "sites: [{name: s, pos: [0, 0, p]}]",
      "sites: [{name: s, pos: [0, 0, 0 .. p]}]",
      "sites: [{name: s, pos: [0, 0, {normal: [0, p]}]}]",
      "sites: [{name: s, pos: [0, 0, {choice: [1, p]}]}]",
      "sites: [{name: s, if: p > 0, pos: [0, 0, 0]}]",
      "sites: [{name: 's_${i}', for: {i: p}, pos: [0, 0, 0]}]",
      "sites: [{name: 's_${p}', pos: [0, 0, 0]}]",
      "sites: [{name: s, rgba: {hsv: [p, 1, 1]}}]",
      "defaults: {site: {size: p}}",
      "checks: {sink: p * 1mm}",
      "mjcf: {option: {timestep: p / 1000}}",
      "bodies: [{name: b, parts: [{name: g, type: sphere, size: p}], pos: [0, 0, 3]}]",
  };
  for (const std::string use : uses) {
    INFO(use);
    const Loaded loaded = LoadWithBox("params: {p: 1}\n" + use + "\n");
    CHECK(loaded.Report() == Strings{});
    CHECK(loaded.Unused() == Strings{});
  }
}

TEST_CASE("a local value that nothing uses is a warning at its name", "[unused]") {
  CHECK(LoadWithBox("sites: [{name: s, let: {a: 1cm, b: a, c: 2}, pos: [0, 0, b]}]\n").Unused() ==
        Strings{"4:39 local value 'c' is never used"});
}

TEST_CASE("texts, vectors and parameters of parameters are used, too", "[unused]") {
  CHECK(LoadWithBox("params: {word: red, place: [1, 2, 3], a: 1, b: a + place.x}\n"
                    "sites: [{name: '${word}', pos: place, size: b}]\n")
            .Unused() == Strings{});
}

TEST_CASE("what a setting replaces is still used", "[unused]") {
  const Loaded loaded =
      Load("mjforge: 1\nname: t\nparams: {a: 1, b: a}\nparts: [{name: s, type: sphere, size: b}]\n",
           {{"b", "2"}});
  CHECK(loaded.Unused() == Strings{});
}

TEST_CASE("a material of the spec itself that nothing wears is a warning", "[unused]") {
  const std::string materials = "materials: {oak: {}, pine: {}, steel: {}}\n";
  CHECK(LoadWithBox(materials + "sites: [{name: s, material: {choice: [oak, pine]}}]\n").Unused() ==
        Strings{"4:32 material 'steel' is never used"});
  CHECK(LoadWithBox(materials + "defaults: {part: {material: oak}}\n").Unused() ==
        Strings{"4:22 material 'pine' is never used", "4:32 material 'steel' is never used"});
  // A composed name may be any.
  CHECK(LoadWithBox(materials + "params: {wood: {choice: [oak, pine]}}\n"
                                "sites: [{name: s, material: '${wood}'}]\n")
            .Unused() == Strings{});
  CHECK(LoadWithBox("import: materials\n").Unused() == Strings{});
}

TEST_CASE("unused names can be silenced, and errors come first", "[unused]") {
  CHECK(LoadWithBox("params: {p: 1}\nchecks: {silence: {spec/unused: for others}}\n").Unused() ==
        Strings{});
  CHECK(LoadWithBox("params: {p: 1}\nmass: p +\n").Unused() == Strings{});
}
