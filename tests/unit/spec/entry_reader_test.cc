#include <catch2/catch.hpp>

#include "loading.h"

namespace {

Strings ReportPart(const std::string& part) {
  return Load("mjforge: 1\nname: t\nparams: {n: 3, v: [1, 2, 3], word: box}\nparts:\n  - " + part +
              "\n")
      .Report();
}

}  // namespace

TEST_CASE("an unknown key gets the nearest one", "[entries]") {
  CHECK(ReportPart("{name: a, type: box, sise: [1, 1, 1]}") ==
        Strings{"5:26 spec/unknown-key: unknown key 'sise' in a part (did you mean 'size'?)"});
  CHECK(ReportPart("{name: a, type: box, size: v, friktion: 1}") ==
        Strings{
            "5:35 spec/unknown-key: unknown key 'friktion' in a part (did you mean 'friction'?)"});
}

TEST_CASE("a part needs a name, a type and what its type needs", "[entries]") {
  CHECK(ReportPart("{type: box, size: v}") ==
        Strings{"5:5 spec/missing-key: part without a 'name'"});
  CHECK(ReportPart("{name: a}") == Strings{"5:5 spec/missing-key: part without a 'type'"});
  CHECK(ReportPart("{name: a, type: prism}") ==
        Strings{"5:5 spec/missing-key: prism without 'polygon'",
                "5:5 spec/missing-key: prism without 'height'"});
  CHECK(
      ReportPart("{name: a, type: bxo, size: v}") ==
      Strings{"5:21 spec/bad-value: 'bxo' is not one of box, sphere, cylinder, capsule, ellipsoid, "
              "prism, lathe, tube, hull, mesh (did you mean 'box'?)"});
  CHECK(ReportPart("{name: a, type: word, size: v}") ==
        Strings{
            "5:21 spec/bad-value: 'word' is not one of box, sphere, cylinder, capsule, ellipsoid, "
            "prism, lathe, tube, hull, mesh (to use the parameter's value, write ${word})"});
}

TEST_CASE("sizes are counted by type", "[entries]") {
  CHECK(ReportPart("{name: a, type: cylinder, size: v}") ==
        Strings{"5:37 spec/wrong-length: a cylinder has 2 sizes, got 3"});
  CHECK(ReportPart("{name: a, type: capsule, size: [1], fromto: [0, 0, 0, 0, 0, 1]}") == Strings{});
  CHECK(ReportPart("{name: a, type: sphere, size: 1, fromto: [0, 0, 0, 0, 0, 1]}") ==
        Strings{"5:38 spec/conflict: 'fromto' has no meaning for a sphere"});
  CHECK(ReportPart("{name: a, type: box, size: v, height: 2}") ==
        Strings{"5:35 spec/conflict: 'height' has no meaning for a box"});
  CHECK(ReportPart("{name: a, type: box, size: v, round_collision: false}") ==
        Strings{"5:35 spec/conflict: 'round_collision' has no meaning for a box without 'round'"});
  CHECK(ReportPart("{name: a, type: box, size: v, round: 0.1, round_collision: false}").empty());
  CHECK(ReportPart("{name: a, type: box, size: v, round: 0.1, facets: 8}") ==
        Strings{"5:47 spec/conflict: 'facets' has no meaning for a box"});
  CHECK(ReportPart("{name: a, type: cylinder, size: [1, 2], facets: 8, crease: 1}") ==
        Strings{"5:45 spec/conflict: 'facets' has no meaning for a cylinder without 'round'",
                "5:56 spec/conflict: 'crease' has no meaning for a cylinder without 'round'"});
  CHECK(ReportPart("{name: a, type: cylinder, size: [1, 2], round: 0.1, facets: 8}").empty());
  CHECK(ReportPart("{name: a, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: 1, "
                   "facets: 8}") ==
        Strings{"5:74 spec/conflict: 'facets' has no meaning for a prism without 'round'"});
}

TEST_CASE("what is said twice is a conflict", "[entries]") {
  CHECK(ReportPart("{name: a, type: box, size: v, density: 1, mass: 1}") ==
        Strings{
            "5:47 spec/conflict: 'mass' together with 'density': a mass is given in only one way"});
  CHECK(ReportPart("{name: a, type: box, size: v, quat: random, euler: [0, 0, 1]}") ==
        Strings{"5:49 spec/conflict: 'euler' together with 'quat': an orientation is given in only "
                "one way"});
}

TEST_CASE("names are checked where they are literal", "[entries]") {
  const std::string hint = " (a letter, then letters, digits and underscores)";
  for (const std::string name : {"a/b", "..", "1a", "a b", "a-b"}) {
    CHECK(ReportPart("{name: '" + name + "', type: box, size: v}") ==
          Strings{"5:12 spec/bad-name: part name '" + name + "' is not a valid name" + hint});
  }
}

TEST_CASE("two entries that surely exist cannot share a name", "[entries]") {
  const Loaded loaded = Load(
      "mjforge: 1\nname: t\nparts:\n"
      "  - {name: a, type: sphere, size: 1}\n"
      "  - {name: a, type: sphere, size: 1, if: index > 2}\n"
      "  - frame: {pos: [0, 0, 1]}\n"
      "    parts: [{name: a, type: sphere, size: 1}]\n");
  REQUIRE(loaded.Report() == Strings{"7:20 spec/duplicate-name: two parts are named 'a'"});
  CHECK(loaded.findings[0].notes.at(0).mark.line == 4);
}

TEST_CASE("loop variables live in their entry only", "[entries]") {
  CHECK(ReportPart("{name: 'a_${i}_${j}', type: sphere, size: i + j + 1, for: {i: n, j: i + 1}}") ==
        Strings{});
  CHECK(ReportPart("{name: a, type: sphere, size: i}").at(0).find("5:35 expr/unknown-name") == 0);
  CHECK(ReportPart("{name: 'a_${n}', type: sphere, size: 1, for: {n: 2}}") ==
        Strings{"5:51 spec/duplicate-name: loop variable 'n' hides another name"});
  CHECK(ReportPart("{name: 'a_${i}', type: sphere, size: 1, for: {i: 1 .. 3}}") ==
        Strings{"5:54 spec/conflict: a loop's count cannot be drawn here (draw it as a parameter "
                "and use that parameter's name)"});
}

TEST_CASE("a frame moves parts and nothing else", "[entries]") {
  CHECK(ReportPart("{frame: {pos: [0, 0, 1]}, parts: [{name: a, type: sphere, size: 1}]}") ==
        Strings{});
  CHECK(ReportPart("{frame: {pos: [0, 0, 1 .. 2]}, parts: []}") ==
        Strings{"5:5 spec/unnamed-draw: a frame whose pose is drawn needs a 'name' (draws are "
                "keyed by names, so moving an entry does not change them)"});
  CHECK(ReportPart("{frame: {pos: [0, 0, 1]}, size: 1}") ==
        Strings{"5:5 spec/missing-key: a frame without 'parts'",
                "5:31 spec/conflict: 'size' has no meaning for a frame"});
}

TEST_CASE("joints are a word or a list", "[entries]") {
  CHECK(ReportWithBox("joints: none\n") == Strings{});
  CHECK(
      ReportWithBox("joints: fre\n") ==
      Strings{
          "4:9 spec/bad-value: 'fre' is neither 'free', 'none' nor a list of joints (did you mean "
          "'free'?)"});
  CHECK(ReportWithBox("joints: [{name: h, type: hinge, axis: [0, 0, 1], range: [0, 90deg]}]\n") ==
        Strings{});
  CHECK(ReportWithBox("joints: [{type: hinge}]\n") ==
        Strings{"4:10 spec/missing-key: joint without a 'name'"});
}
