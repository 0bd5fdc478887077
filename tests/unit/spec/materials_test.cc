#include <catch2/catch.hpp>

#include "loading.h"

TEST_CASE("a missing material is reported at its name", "[materials]") {
  CHECK(Load("mjforge: 1\nname: t\nmaterials: {wood: {}, steel: {}}\n"
             "parts: [{name: a, type: sphere, size: 1, material: stel}]\n")
            .Report() ==
        Strings{"4:52 spec/unknown-material: no material 'stel' (did you mean 'steel'?)"});
}

TEST_CASE("a texture is builtin or a file", "[materials]") {
  CHECK(ReportWithBox("materials: {m: {texture: {builtin: flat, rgb1: [1, 0, 0]}}}\n") ==
        Strings{});
  CHECK(ReportWithBox("materials: {m: {texture: {type: cube}}}\n") ==
        Strings{"4:26 spec/missing-key: a texture needs 'builtin' or 'file'"});
  CHECK(ReportWithBox("materials: {m: {texture: {builtin: flat, file: a.png}}}\n") ==
        Strings{"4:42 spec/conflict: 'file' together with 'builtin': a texture is given in only "
                "one way"});
  CHECK(ReportWithBox("materials: {m: {texture: wood.png}}\n") ==
        Strings{
            "4:26 spec/wrong-type: expected a mapping with a texture's keys, got a single value"});
}

TEST_CASE("defaults give what entries leave out", "[materials]") {
  const Loaded loaded = Load(
      "mjforge: 1\nname: t\n"
      "defaults: {part: {type: sphere, size: 1, friction: 0.5}}\nparts: [{name: a}]\n");
  REQUIRE(loaded.Report() == Strings{});
  CHECK(loaded.spec->defaults.part.size() == 3);
  CHECK(ReportWithBox("defaults: {part: {name: a}}\n") ==
        Strings{"4:19 spec/conflict: 'name' cannot be a default"});
}
