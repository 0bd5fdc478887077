#include <catch2/catch.hpp>

#include "loading.h"

namespace {

// The keys of the first part's fields; of defaults in brackets.
std::string Fields(const std::string& part, const std::string& defaults) {
  const Loaded loaded = Load("mjforge: 1\nname: t\ndefaults: {part: {" + defaults +
                             "}}\nparts: [{name: a, type: cylinder, " + part + "}]\n");
  CHECK(loaded.Report() == Strings{});
  std::string keys;
  if (loaded.spec == nullptr) return keys;
  for (const mjforge::spec::Field& field : loaded.spec->parts[0].fields) {
    if (!keys.empty()) keys += ' ';
    keys += field.is_default ? "(" + std::string(field.info->key) + ")" : field.info->key;
  }
  return keys;
}

}  // namespace

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

TEST_CASE("what an entry says itself, in any way, takes the place of the default", "[materials]") {
  CHECK(Fields("size: [1, 2]", "size: [3, 4], friction: 0.5") == "type size (friction)");
  CHECK(Fields("size: [1, 2], mass: 1", "density: 5") == "type size mass");
  CHECK(Fields("size: [1, 2]", "density: 5") == "type size (density)");
  CHECK(Fields("size: [1, 2], euler: [0, 0, 1]", "quat: [1, 0, 0, 0], pos: [0, 0, 1]") ==
        "type size euler (pos)");
  CHECK(Fields("size: [1], fromto: [0, 0, 0, 0, 0, 1]", "pos: [0, 0, 1], zaxis: [1, 0, 0]") ==
        "type size fromto");
  CHECK(Fields("size: [1, 2], rgba: [1, 0, 0, 1]", "rgba: [0, 1, 0, 1], margin: 1") ==
        "type size rgba (margin)");
}
