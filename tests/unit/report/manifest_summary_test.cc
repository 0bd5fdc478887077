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

TEST_CASE_METHOD(SummaryTest, "a long manifest, read in sections, has the summary of its records") {
  constexpr std::uint64_t kBytes = std::uint64_t{20} << 20;  // three sections
  ManifestSummary expected(10);
  std::string text;
  std::uint64_t count = 0;
  for (; text.size() < kBytes; ++count) {
    manifest::Record record = RecordOf(count, count % 5 == 0 ? "failed" : "ok");
    record.params = {{"colour", std::string(count % 3 == 0 ? "red" : "blue")},
                     {"radius", 0.1 + 1e-7 * static_cast<double>(count)}};
    if (count % 5 == 0) record.findings = {FindingOf("mujoco/error", std::to_string(count))};
    manifest::AppendRecord(text, record);
    expected.Add(record);
  }
  const auto summary = Summarize("manifest.jsonl", text);
  REQUIRE(summary);
  CHECK(summary->variants == count);
  CHECK(summary->last_index == count - 1);
  CHECK(summary->first->index == 0);
  CHECK(summary->statuses.failed == expected.statuses.failed);
  CHECK(summary->codes.at("mujoco/error").variants == expected.statuses.failed);
  CHECK(summary->codes.at("mujoco/error").example.message == "0");
  CHECK(IndicesOf(summary->Choose()) == IndicesOf(expected.Choose()));
  CHECK(summary->points.Take(5).size() == 5);
  const ParameterTally& colour = *summary->params.Find("colour");
  CHECK(colour.Values()[1].second.all == expected.params.Find("colour")->Values()[1].second.all);
  const NumberTally& radius = summary->params.Find("radius")->numbers[0];
  const NumberTally& all = expected.params.Find("radius")->numbers[0];
  CHECK(radius.all.mean() == Approx(all.all.mean()).epsilon(1e-12));
  CHECK(radius.good.StandardDeviation() == Approx(all.good.StandardDeviation()).epsilon(1e-12));
  CHECK(radius.bad.count() == all.bad.count());
  CHECK(radius.all.Bins(0, 1, 50) == all.all.Bins(0, 1, 50));
  // The same again: the division depends only on the file.
  const auto again = Summarize("manifest.jsonl", text);
  CHECK(again->params.Find("radius")->numbers[0].good.m2 == radius.good.m2);
}

TEST_CASE_METHOD(SummaryTest, "bad lines of a long manifest have their numbers in the file") {
  const std::string piece = ManifestOf(1000);
  std::string text;
  for (std::uint64_t i = 0; text.size() < std::uint64_t{20} << 20; ++i)
    text += piece + "bad " + std::to_string(i) + "\n";
  const auto summary = Summarize("manifest.jsonl", text);
  REQUIRE(summary);
  CHECK(bad_lines == summary->variants / 1000);
  REQUIRE(findings.size() > 15);
  for (std::uint32_t i = 0; i < findings.size(); ++i) {
    CHECK(findings[i].mark.line == (i + 1) * 1001);
    CHECK(sources.Line(findings[i].mark) == "bad " + std::to_string(i));
  }
}

TEST_CASE_METHOD(SummaryTest, "a compressed manifest has the summary of its text") {
  bytes::FrameCompressor compressor;
  const std::string text = ManifestOf(100, 3);
  const std::string first(compressor.Compress(text));
  const std::string frames = first + std::string(compressor.Compress(ManifestOf(1)));
  CHECK(Summarize("m.jsonl.zst", frames)->variants == 101);
  CHECK(findings.empty());
  const std::string cut = frames.substr(0, frames.size() - 50);
  CHECK(Summarize(".m.jsonl.zst.part", cut)->variants == 100);
  CHECK(findings.empty());
  CHECK_FALSE(Summarize("m.jsonl.zst", cut));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "cannot read this line: its last frame is incomplete");
  CHECK(findings[0].mark.line == 101);
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
