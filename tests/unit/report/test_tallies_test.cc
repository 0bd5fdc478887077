#include "mjforge/report/test_tallies.h"

#include <catch2/catch.hpp>

namespace mjforge::report {
namespace {

using physics::Result;

std::string TextOf(const TestTallies& tests) {
  std::string text;
  for (const TestTally& test : tests.list()) {
    text += test.name + " " + std::to_string(test.passed) + "/" + std::to_string(test.failed);
    if (test.ways > 0)
      text += " (" + std::to_string(test.held) + " of " + std::to_string(test.ways) + ")";
    text += "; ";
  }
  return text;
}

Result::Grasp GraspAt(const std::string& site, bool held) {
  return {.site = site, .body = "mug", .held = held};
}

TEST_CASE("tests of the SimReady benchmark count where they apply") {
  TestTallies tests;
  Result result;
  tests.Add(result);
  CHECK(tests.list().empty());
  result.simready = {.ground_drop = "pass", .slope_drop = "fail"};
  tests.Add(result);
  result.simready->slope_drop = "pass";
  tests.Add(result);
  CHECK(TextOf(tests) == "ground_drop 2/0; slope_drop 1/1; ");
}

TEST_CASE("balls and pegs count a variant where all of them do as they should") {
  TestTallies tests;
  Result result;
  result.fits = Result::Fitting{2, 1};
  result.holds = Result::Holding{5, 5, 5};
  tests.Add(result);
  result.fits->fit = 2;
  result.holds->held = 4;
  tests.Add(result);
  CHECK(TextOf(tests) == "holds 1/1; fits 1/1; ");
}

TEST_CASE("a variant is grasped at a site where one of the ways holds") {
  TestTallies tests;
  Result result;
  result.grasps = {GraspAt("a", false), GraspAt("a", true), GraspAt("b", false)};
  tests.Add(result);
  tests.Add(result);
  CHECK(TextOf(tests) == "a 2/0 (2 of 4); b 0/2 (0 of 2); ");
}

TEST_CASE("sites that differ from variant to variant do not fill a page") {
  TestTallies tests;
  for (std::size_t i = 0; i < 2 * TestTallies::kMost; ++i) {
    Result result;
    result.grasps = {GraspAt(std::to_string(i), true)};
    tests.Add(result);
  }
  CHECK(tests.list().size() == TestTallies::kMost);
}

}  // namespace
}  // namespace mjforge::report
