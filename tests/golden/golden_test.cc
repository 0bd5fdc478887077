#include <catch2/catch.hpp>

#include "golden/golden_case.h"
#include "harness/effort.h"

namespace mjforge::golden {
namespace {

TEST_CASE("every bad spec gets the findings and the exit status that are written beside it") {
  const std::vector<GoldenCase> cases = FindCases("errors", "mjforge check spec.yaml -n 1");
  REQUIRE(cases.size() >= 50);
  // The fuzzers read such specs, too.
  const auto step = static_cast<std::size_t>(harness::Effort(1, 3));
  for (std::size_t i = 0; i < cases.size(); i += step) CheckCase(cases[i]);
}

TEST_CASE("every good spec gives the bytes that are written beside it") {
  const std::vector<GoldenCase> cases =
      FindCases("good", "mjforge generate spec.yaml --seed 1 -o -");
  REQUIRE(cases.size() >= 12);
  for (const GoldenCase& golden : cases) CheckCase(golden);
}

}  // namespace
}  // namespace mjforge::golden
