#include "mjforge/report/manifest_summary.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "report_records.h"

namespace mjforge::report {
namespace {

struct SummaryTest {
  std::optional<ManifestSummary> Summarize(const std::string& name, const std::string& text,
                                           std::size_t shown = 10) {
    return report::Summarize(folder.Write(name, text), shown, sources, findings, bad_lines);
  }

  harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
  std::uint64_t bad_lines = 0;
};

std::vector<std::uint64_t> IndicesOf(const std::vector<ShownVariant>& shown) {
  std::vector<std::uint64_t> indices;
  for (const ShownVariant& variant : shown) indices.push_back(variant.record.index);
  return indices;
}

std::ptrdiff_t Failed(const std::vector<ShownVariant>& shown) {
  return std::count_if(shown.begin(), shown.end(), [](const ShownVariant& variant) {
    return variant.reason == ShownVariant::Reason::kFailed;
  });
}

TEST_CASE_METHOD(SummaryTest, "a batch is counted by status, code and measure") {
  const auto summary = Summarize("manifest.jsonl", ManifestOf(100, 10));
  REQUIRE(summary);
  CHECK(findings.empty());
  CHECK(summary->variants == 100);
  CHECK(summary->last_index == 99);
  CHECK(summary->statuses.ok == 90);
  CHECK(summary->statuses.failed == 10);
  REQUIRE(summary->codes.size() == 1);
  const CodeTally& code = summary->codes.at("mujoco/error");
  CHECK(code.variants == 10);
  CHECK(code.index == 9);
  CHECK(code.example.message == "it does not load");
  CHECK(code.example.place == "mug.yaml:3:5");
  CHECK(code.example.hint == "mend it");
  // Failed ones have no object.
  CHECK(summary->measures[static_cast<std::size_t>(MeasureId::kMass)].all.count() == 90);
  CHECK(summary->points.seen() == 90);
  CHECK(summary->params.Find("height")->numbers[0].bad.count() == 10);
  CHECK(summary->params.Find("shape")->Values().size() == 2);
}

TEST_CASE("the size of an object is the largest side of its box") {
  const manifest::Record record = RecordOf(3);
  REQUIRE(SizeOf(record));
  CHECK(*SizeOf(record) == Approx(0.26));
  CHECK_FALSE(SizeOf(RecordOf(3, "failed")));
}

TEST_CASE("a code counts once for a variant that has it twice") {
  ManifestSummary summary(10);
  manifest::Record record = RecordOf(0, "failed");
  record.findings = {FindingOf("mujoco/error", "one"), FindingOf("mujoco/error", "two"),
                     FindingOf("mujoco/warning", "three", "warning"), "not JSON", "[]"};
  summary.Add(record);
  CHECK(summary.codes.at("mujoco/error").variants == 1);
  CHECK(summary.codes.at("mujoco/error").example.message == "one");
  CHECK(summary.codes.at("mujoco/warning").example.severity == "warning");
  CHECK(summary.codes.size() == 2);
}

TEST_CASE_METHOD(SummaryTest, "few variants are all shown, the failed first") {
  const auto summary = Summarize("manifest.jsonl", ManifestOf(5, 2), 10);
  CHECK(IndicesOf(summary->Choose()) == std::vector<std::uint64_t>{1, 3, 0, 2, 4});
}

TEST_CASE_METHOD(SummaryTest, "of many variants half of those shown may be failed ones") {
  const auto summary = Summarize("manifest.jsonl", ManifestOf(1000, 2), 10);
  const std::vector<ShownVariant> shown = summary->Choose();
  CHECK(shown.size() == 10);
  CHECK(Failed(shown) == 5);
  std::vector<std::uint64_t> indices = IndicesOf(shown);
  std::sort(indices.begin(), indices.end());
  CHECK(std::adjacent_find(indices.begin(), indices.end()) == indices.end());
  CHECK(indices.back() > 500);
}

TEST_CASE_METHOD(SummaryTest, "where all failed, failed ones are all that is shown") {
  const auto summary = Summarize("manifest.jsonl", ManifestOf(100, 1), 10);
  CHECK(Failed(summary->Choose()) == 10);
  const auto few = Summarize("few.jsonl", ManifestOf(100, 50), 10);
  CHECK(Failed(few->Choose()) == 2);
  CHECK(few->Choose().size() == 10);
}

TEST_CASE("of those shown a quarter at most is there because it is slow") {
  for (const auto& [count, slow] : {std::pair(50, 12), std::pair(1000, 50), std::pair(3, 0)}) {
    ManifestSummary summary(200);
    for (int i = 0; i < count; ++i) {
      manifest::Record record = RecordOf(static_cast<std::uint64_t>(i));
      record.physics.emplace();
      record.physics->dropped = record.physics->at_rest = true;
      record.physics->time = i;
      summary.Add(record);
    }
    const std::vector<ShownVariant> shown = summary.Choose();
    CHECK(shown.size() == static_cast<std::size_t>(std::min(count, 200)));
    CHECK(std::count_if(shown.begin(), shown.end(), [](const ShownVariant& variant) {
            return variant.reason == ShownVariant::Reason::kSlow;
          }) == slow);
  }
}

TEST_CASE_METHOD(SummaryTest, "to show none is possible") {
  const auto summary = Summarize("manifest.jsonl", ManifestOf(100, 3), 0);
  CHECK(summary->variants == 100);
  CHECK(summary->Choose().empty());
}

TEST_CASE_METHOD(SummaryTest, "lines that are no records are findings and left out") {
  const auto summary = Summarize("manifest.jsonl", ManifestOf(2) + "x\n" + ManifestOf(1) + "y\n");
  REQUIRE(summary);
  CHECK(summary->variants == 3);
  CHECK(bad_lines == 2);
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].mark.line == 3);
  CHECK(findings[1].mark.line == 5);
}

TEST_CASE_METHOD(SummaryTest, "a line cut off is no fault of a manifest under construction") {
  const std::string text = ManifestOf(3) + ManifestOf(1).substr(0, 50);
  CHECK(Summarize(".manifest.jsonl.part", text)->variants == 3);
  CHECK(findings.empty());
  CHECK(bad_lines == 0);
  CHECK(Summarize("manifest.jsonl", text)->variants == 3);
  CHECK(findings.size() == 1);
  CHECK(bad_lines == 1);
}

TEST_CASE("a record of another batch is noticed") {
  ManifestSummary summary(10);
  summary.Add(RecordOf(0));
  manifest::Record other = RecordOf(1);
  summary.Add(other);
  CHECK(summary.other_batch.empty());
  other.seed = 7;
  summary.Add(other);
  CHECK(summary.other_batch == "seed is '7', not '0'");
}

}  // namespace
}  // namespace mjforge::report
