#include "mjforge/report/page_sections.h"

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "report_records.h"

namespace mjforge::report {
namespace {

ParameterTallies ExpectedOf(const std::string& params, std::uint64_t first = 0,
                            std::uint64_t last = 99) {
  const harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
  const std::string text =
      "mjforge: 1\nname: crate\n" + params + "parts: [{name: body, type: sphere, size: 0.1}]\n";
  const auto recipe =
      forge::LoadRecipe(folder.Write("crate.yaml", text).string(), {}, sources, findings);
  for (const diag::Finding& finding : findings) UNSCOPED_INFO(finding.message);
  REQUIRE(recipe);
  ManifestSummary summary(0);
  summary.Add(RecordOf(first));
  summary.Add(RecordOf(last));
  return DrawExpected(*recipe, summary);
}

const Histogram& Numbers(const ParameterTallies& expected, const char* name) {
  return expected.Find(name)->numbers.at(0).all;
}

TEST_CASE("what is asked for has the distribution's moments") {
  const ParameterTallies expected = ExpectedOf("params: {a: 1 .. 3, b: {normal: [10, 2]}}\n");
  CHECK(Numbers(expected, "a").count() == 20'000);
  CHECK(Numbers(expected, "a").mean() == Approx(2).margin(0.02));
  CHECK(Numbers(expected, "a").min() >= 1);
  CHECK(Numbers(expected, "a").max() <= 3);
  CHECK(Numbers(expected, "b").StandardDeviation() == Approx(2).margin(0.05));
}

TEST_CASE("what is asked for depends on other parameters and meets the requirements") {
  const ParameterTallies expected = ExpectedOf(
      "params: {a: 1 .. 3, b: 0 .. a}\n"
      "require: [b > 1]\n");
  CHECK(Numbers(expected, "b").min() > 1);
  CHECK(Numbers(expected, "b").max() <= 3);
  // Without the requirement it would be 2: large a are accepted more often.
  CHECK(Numbers(expected, "a").mean() > 2.2);
}

TEST_CASE("choices are asked for as often as they weigh") {
  const ParameterTallies expected =
      ExpectedOf("params: {kind: {choice: [light, heavy], weights: [3, 1]}}\n");
  const auto values = expected.Find("kind")->Values();
  REQUIRE(values.size() == 2);
  CHECK(values[0].first == "heavy");
  CHECK(static_cast<double>(values[0].second.all) / 20'000 == Approx(0.25).margin(0.02));
}

TEST_CASE("what depends on the index is asked for over the batch's indices") {
  const ParameterTallies expected = ExpectedOf("params: {a: index}\n", 1000, 1999);
  CHECK(Numbers(expected, "a").min() == 1000);
  CHECK(Numbers(expected, "a").max() == 1999);
  CHECK(Numbers(expected, "a").mean() == Approx(1499.5).margin(1));
}

TEST_CASE("a spec that rejects all draws asks for nothing, and soon") {
  CHECK(ExpectedOf("params: {a: 0 .. 1}\nrequire: [a > 2]\n").list().empty());
}

}  // namespace
}  // namespace mjforge::report
