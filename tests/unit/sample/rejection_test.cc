// Redraws until the requirements hold, and reports if they cannot hold.

#include <catch2/catch.hpp>

#include "loading.h"

namespace mjforge::sample {
namespace {

double FirstParameter(const std::optional<Evaluator>& evaluator) {
  return std::get<double>(evaluator.value().Parameter(0));
}

TEST_CASE("attempts count up until the requirements hold") {
  Family family = Load("{r: 0 .. 1}", "require: [r > 0.9]");
  for (std::uint64_t index = 0; index < 20; ++index) {
    std::uint64_t attempt = 0;
    while (family.Number("r", {.seed = 3, .index = index, .attempt = attempt}) <= 0.9) ++attempt;
    const auto evaluator =
        Sample(*family.spec, {.seed = 3, .index = index}, kRootStream, {}, family.findings);
    REQUIRE(evaluator);
    CHECK(evaluator->key().attempt == attempt);
    CHECK(FirstParameter(evaluator) ==
          family.Number("r", {.seed = 3, .index = index, .attempt = attempt}));
  }
  CHECK(family.Report() == Strings{});
}

TEST_CASE("attempts begin at the key's attempt") {
  Family family = Load("{r: 0 .. 1}");
  const auto evaluator = Sample(*family.spec, {.attempt = 12}, kRootStream, {}, family.findings);
  CHECK(evaluator.value().key().attempt == 12);
}

TEST_CASE("a draw that is rejected once too often is found with its requirements") {
  CHECK(ReportOf("{a: 0 .. 1, b: 0 .. 1}", "require:\n  - a > 0.5\n  - b > 2\n  - a + b < 9") ==
        Strings{"6:5 sample/rejected: no draw in 1000 attempts met all requirements (loosen a "
                "requirement, or narrow the ranges it compares) 7/3",
                "  5:5 'a > 0.5' rejected 470 times", "  6:5 'b > 2' rejected 530 times",
                "  7:5 'a + b < 9' rejected 0 times"});
}

TEST_CASE("a requirement that hangs on no draw fails at the first attempt") {
  CHECK(ReportOf("{a: 1, b: {cycle: [a, 2 * a]}}", "require:\n  - a > 0\n  - b > 3 * a") ==
        Strings{"6:5 sample/rejected: requirement 'b > 3 * a' does not hold: b = 2, a = 1 (no "
                "parameter is drawn, so a redraw cannot help) 7/3"});
}

TEST_CASE("a draw that is pinned does not count as one") {
  Family family = Load("{a: 0 .. 1}", "require: [a > 1]");
  const std::vector<std::pair<std::string, ParameterValue>> pinned = {{"a", 0.5}};
  CHECK_FALSE(Sample(*family.spec, {}, kRootStream, pinned, family.findings));
  CHECK(family.Report() == Strings{"4:11 sample/rejected: requirement 'a > 1' does not hold: a = "
                                   "0.5 (no parameter is drawn, so a redraw cannot help) 0/0"});
}

TEST_CASE("a draw anywhere in a value counts as one") {
  for (const char* value : {"[1, 0 .. 1]", "{hsv: [0, 0 .. 1, 1]}", "{cycle: [1 .. 2, 3]}"}) {
    Family family = Load("{a: " + std::string(value) + ", b: 1}", "require: [b > 1]");
    Sample(*family.spec, {}, kRootStream, {}, family.findings);
    REQUIRE(family.findings.size() == 1);
    CHECK(family.findings[0].message == "no draw in 1000 attempts met all requirements");
  }
}

TEST_CASE("a failing draw ends the attempts") {
  CHECK(ReportOf("{a: 0 .. 1, b: 1 .. a}", "require: [a > 2]") ==
        Strings{"3:24 sample/empty-range: range 1 .. 0.932247 is empty: its lower end is above its "
                "upper end (write the lower end first, or keep the ends apart with min() and "
                "max()) 7/3"});
}

}  // namespace
}  // namespace mjforge::sample
