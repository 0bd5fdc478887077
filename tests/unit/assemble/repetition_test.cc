// Tests of `for`, `if` and `let`.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

std::vector<std::string> PartNames(const std::string& body) {
  const Assembling thing(body);
  std::vector<std::string> names;
  for (const model::Part& part : thing.body().parts) names.push_back(part.name.substr(6));
  return names;
}

using Names = std::vector<std::string>;

TEST_CASE("several loops run as an odometer, the first outermost") {
  CHECK(PartNames("parts: [{name: 'a${i}${j}', for: {i: 2, j: 3}, type: sphere, size: [1]}]\n") ==
        Names{"a00", "a01", "a02", "a10", "a11", "a12"});
}

TEST_CASE("a count may depend on an outer loop's variable") {
  CHECK(PartNames("parts: [{name: 'a${i}${j}', for: {i: 3, j: i}, type: sphere, size: [1]}]\n") ==
        Names{"a10", "a20", "a21"});
}

TEST_CASE("a condition is tested for each instance") {
  CHECK(PartNames("parts: [{name: 'a${i}', for: {i: 5}, if: i % 2 == 0, type: sphere, size: "
                  "[1 + i]}]\n") == Names{"a0", "a2", "a4"});
}

TEST_CASE("a list of booleans says which instances exist, and is looped over") {
  CHECK(PartNames("params: {there: [true, false, true]}\n"
                  "parts: [{name: 'a${i}', for: {i: len(there)}, if: 'there[i]', type: sphere, "
                  "size: [1]}]\n") == Names{"a0", "a2"});
  CHECK(PartNames("params: {sides: [true, false]}\n"
                  "parts: [{name: 'a_${left}', for: {left: sides}, type: sphere, size: [1], "
                  "pos: [\"left ? 3 : 0\", 0, 0]}]\n") == Names{"a_true", "a_false"});
}

TEST_CASE("frames repeat, too") {
  const Assembling thing(
      "parts:\n"
      "- frame: {pos: [i, 0, 0]}\n"
      "  for: {i: 2}\n"
      "  parts: [{name: 'a${i}${j}', for: {j: 2}, type: sphere, size: [1], pos: [0, j, 0]}]\n");
  REQUIRE(thing.body().parts.size() == 4);
  CHECK(thing.part("thing_a10").X_BG.p == Eigen::Vector3d(1, 0, 0));
  CHECK(thing.part("thing_a01").X_BG.p == Eigen::Vector3d(0, 1, 0));
}

TEST_CASE("a count of 0 leaves the entry out") {
  CHECK(PartNames("parts:\n"
                  "- {name: 'a${i}', for: {i: 0}, type: sphere, size: [1]}\n"
                  "- {name: b, type: sphere, size: [1]}\n") == Names{"b"});
}

TEST_CASE("a negative count is an error") {
  CHECK(OnlyFinding("params: {n: -1}\n"
                    "parts: [{name: 'a${i}', for: {i: n}, type: sphere, size: [1]}]\n") ==
        "4:34 count of loop 'i' is -1; it must be a whole number, 0 or more");
}

TEST_CASE("too many instances are refused before any is made") {
  const std::string too_many = "'for' makes more instances than the 40000 parts an object may have";
  for (const std::string loops :
       {"i: 1e9", "i: 1e5, j: 1e5", "i: 100001", "i: 1e9, j: 0", "i: 1e300", "i: 1000, j: 1000"}) {
    INFO(loops);
    CHECK(OnlyFinding("parts: [{name: a, for: {" + loops + "}, type: sphere, size: [1]}]\n") ==
          "3:28 " + too_many);
  }
  for (const std::string loops : {"i: 1e9", "i: 1e5, j: 1e5", "i: 1e9, j: 0"}) {
    INFO(loops);
    CHECK(OnlyFinding("parts: [{frame: {}, for: {" + loops +
                      "}, parts: [{name: a, type: sphere, size: [1]}]}]\n") == "3:30 " + too_many);
  }
}

TEST_CASE("instances of frames count together with the parts in them") {
  CHECK(OnlyFinding("parts: [{frame: {}, for: {i: 1000}, parts: [{name: 'a${i}_${j}', for: {j: "
                    "101}, type: sphere, size: [1]}]}]\n") ==
        "3:75 'for' makes more instances than the 40000 parts an object may have");
}

TEST_CASE("a condition may pick few out of many cells") {
  const Assembling thing(
      "parts: [{name: 'a${i}', for: {i: 100, j: 100, k: 20}, if: j == 0 && k == 0, type: sphere, "
      "size: [1]}]\n");
  CHECK(thing.body().parts.size() == 100);
}

TEST_CASE("only the first failing instance is reported") {
  CHECK(OnlyFinding("parts: [{name: 'a${i}', for: {i: 9}, type: sphere, size: [2 - i]}]\n") ==
        "3:59 size of part 'a2' is 0; it must be greater than 0 (it is the value of '2 - i')");
}

// Returns the radii of the parts.
std::vector<double> Radii(const std::string& parts) {
  const Assembling thing("params: {n: 2}\nparts:\n" + parts);
  std::vector<double> radii;
  for (const model::Part& part : thing.body().parts) radii.push_back(part.shape.size.x());
  return radii;
}

TEST_CASE("a local value is drawn for each instance, whatever else there is") {
  const auto alone =
      Radii("- {name: 'a${i}', for: {i: n}, let: {r: 1 .. 2}, type: sphere, size: r}\n");
  REQUIRE(alone.size() == 2);
  CHECK(alone[0] != alone[1]);
  const auto among_others = Radii(
      "- {name: b, type: sphere, size: 1 .. 2}\n"
      "- {name: 'a${i}', for: {i: n + 1}, let: {q: 1 .. 2, r: 1 .. 2}, type: sphere, size: r}\n");
  REQUIRE(among_others.size() == 4);
  CHECK(among_others[1] == alone[0]);
  CHECK(among_others[2] == alone[1]);
}

TEST_CASE("local values are known in what is in the entry, and in its condition") {
  CHECK(Radii("- name: f${i}\n"
              "  for: {i: 4}\n"
              "  let: {r: i + 1, even: i % 2 == 0}\n"
              "  if: even\n"
              "  frame: {pos: [r, 0, 0]}\n"
              "  parts: [{name: 'a${i}${k}', for: {k: r}, let: {s: r + k}, type: sphere, size: "
              "s}]\n") == std::vector<double>{1, 3, 4, 5});
}

TEST_CASE("what is left out by its condition needs no local values that can be computed") {
  CHECK(
      Radii(
          "- {name: 'a${i}', for: {i: 3}, let: {r: 1 / i}, if: i > 0, type: sphere, size: r}\n") ==
      std::vector<double>{1, 0.5});
  CHECK(
      OnlyFinding("parts: [{name: 'a${i}', for: {i: 2}, let: {r: 1 / i}, type: sphere, size: r}]\n")
          .find("expression '1 / i' is infinite") != std::string::npos);
}

TEST_CASE("local values may be texts, lists and booleans") {
  const Assembling thing(
      "parts:\n"
      "- {name: a, let: {word: box, at: [1, 2, 3], big: 2 > 1}, type: '${word}', pos: at,\n"
      "   size: ['big ? 1 : 2', at.y, at.z]}\n");
  CHECK(thing.part("thing_a").X_BG.p == Eigen::Vector3d(1, 2, 3));
  CHECK(thing.part("thing_a").shape.size == Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace mjforge::assemble
