#include "mjforge/report/sections.h"

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "report_records.h"

namespace mjforge::report {
namespace {

ParameterTallies AskOf(const std::string& params, std::uint64_t first = 0,
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
  Gathered gathered(0);
  gathered.Add(RecordOf(first));
  gathered.Add(RecordOf(last));
  return Ask(*recipe, gathered);
}

const Histogram& Numbers(const ParameterTallies& asked, const char* name) {
  return asked.Find(name)->numbers.at(0).all;
}

TEST_CASE("what is asked for has the distribution's moments") {
  const ParameterTallies asked = AskOf("params: {a: 1 .. 3, b: {normal: [10, 2]}}\n");
  CHECK(Numbers(asked, "a").count() == 20'000);
  CHECK(Numbers(asked, "a").mean() == Approx(2).margin(0.02));
  CHECK(Numbers(asked, "a").min() >= 1);
  CHECK(Numbers(asked, "a").max() <= 3);
  CHECK(Numbers(asked, "b").StandardDeviation() == Approx(2).margin(0.05));
}

TEST_CASE("what is asked for depends on other parameters and meets the requirements") {
  const ParameterTallies asked = AskOf(
      "params: {a: 1 .. 3, b: 0 .. a}\n"
      "require: [b > 1]\n");
  CHECK(Numbers(asked, "b").min() > 1);
  CHECK(Numbers(asked, "b").max() <= 3);
  // Without the requirement it would be 2: large a are accepted more often.
  CHECK(Numbers(asked, "a").mean() > 2.2);
}

TEST_CASE("choices are asked for as often as they weigh") {
  const ParameterTallies asked =
      AskOf("params: {kind: {choice: [light, heavy], weights: [3, 1]}}\n");
  const auto values = asked.Find("kind")->Values();
  REQUIRE(values.size() == 2);
  CHECK(values[0].first == "heavy");
  CHECK(static_cast<double>(values[0].second.all) / 20'000 == Approx(0.25).margin(0.02));
}

TEST_CASE("what depends on the index is asked for over the batch's indices") {
  const ParameterTallies asked = AskOf("params: {a: index}\n", 1000, 1999);
  CHECK(Numbers(asked, "a").min() == 1000);
  CHECK(Numbers(asked, "a").max() == 1999);
  CHECK(Numbers(asked, "a").mean() == Approx(1499.5).margin(1));
}

TEST_CASE("a spec that rejects all draws asks for nothing, and soon") {
  CHECK(AskOf("params: {a: 0 .. 1}\nrequire: [a > 2]\n").list().empty());
}

}  // namespace
}  // namespace mjforge::report
