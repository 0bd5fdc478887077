#include "mjforge/report/trials.h"

#include <catch2/catch.hpp>

namespace mjforge::report {
namespace {

using physics::Result;

std::string TextOf(const Trials& trials) {
  std::string text;
  for (const Trial& trial : trials.list()) {
    text += trial.name + " " + std::to_string(trial.passed) + "/" + std::to_string(trial.failed);
    if (trial.ways > 0)
      text += " (" + std::to_string(trial.held) + " of " + std::to_string(trial.ways) + ")";
    text += "; ";
  }
  return text;
}

Result::Grasp GraspAt(const std::string& site, bool held) {
  return {.site = site, .body = "mug", .held = held};
}

TEST_CASE("tests of the SimReady benchmark count where they apply") {
  Trials trials;
  Result result;
  trials.Add(result);
  CHECK(trials.list().empty());
  result.simready = {.ground_drop = "pass", .slope_drop = "fail"};
  trials.Add(result);
  result.simready->slope_drop = "pass";
  trials.Add(result);
  CHECK(TextOf(trials) == "ground_drop 2/0; slope_drop 1/1; ");
}

TEST_CASE("balls and pegs count a variant where all of them do as they should") {
  Trials trials;
  Result result;
  result.fits = Result::Fitting{2, 1};
  result.holds = Result::Holding{5, 5, 5};
  trials.Add(result);
  result.fits->fit = 2;
  result.holds->held = 4;
  trials.Add(result);
  CHECK(TextOf(trials) == "holds 1/1; fits 1/1; ");
}

TEST_CASE("a variant is grasped at a site where one of the ways holds") {
  Trials trials;
  Result result;
  result.grasps = {GraspAt("a", false), GraspAt("a", true), GraspAt("b", false)};
  trials.Add(result);
  trials.Add(result);
  CHECK(TextOf(trials) == "a 2/0 (2 of 4); b 0/2 (0 of 2); ");
}

TEST_CASE("sites that differ from variant to variant do not fill a page") {
  Trials trials;
  for (std::size_t i = 0; i < 2 * Trials::kMost; ++i) {
    Result result;
    result.grasps = {GraspAt(std::to_string(i), true)};
    trials.Add(result);
  }
  CHECK(trials.list().size() == Trials::kMost);
}

}  // namespace
}  // namespace mjforge::report
