// Tests of layouts: batches of one structure, and a folder per structure.

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "crate_batch.h"

namespace mjforge::batch {
namespace {

using forge::Layout;

/// A crate that is a box or a cylinder.
constexpr const char* kTwoShapes =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  half: 0.1 .. 0.2\n"
    "  shape: {choice: [box, cylinder]}\n"
    "parts:\n"
    "  - {name: body, if: \"shape == 'box'\", type: box, size: [half, half, half]}\n"
    "  - {name: body, if: \"shape == 'cylinder'\", type: cylinder, size: [half, half]}\n";

struct LayoutTest : CrateBatch {
  LayoutTest() : CrateBatch(kTwoShapes) {}

  Request With(Layout layout, std::uint64_t count, const std::string& output) const {
    Request request = Of(count, output);
    request.variant.validation = forge::Validation::kLoad;
    request.variant.layout = layout;
    return request;
  }
  std::vector<manifest::Record> Records(const std::string& output) const {
    std::vector<manifest::Record> records;
    const std::string text = ManifestText(output);
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      std::string why_not;
      records.push_back(*manifest::ReadRecord(text.substr(at, end - at), why_not));
      at = end + 1;
    }
    return records;
  }
};

const std::string& ShapeOf(const manifest::Record& record) {
  return std::get<std::string>(record.params[1].second);
}

TEST_CASE_METHOD(LayoutTest, "records name the structures of loaded variants") {
  Make(With(Layout::kAny, 30, "out"));
  std::map<std::string, std::string> shapes;
  for (const manifest::Record& record : Records("out")) {
    CHECK(record.structure.size() == 12);
    CHECK(shapes.emplace(record.structure, ShapeOf(record)).first->second == ShapeOf(record));
  }
  CHECK(shapes.size() == 2);
  Make(Of(1, "unchecked"));
  CHECK(Records("unchecked")[0].structure.empty());
}

TEST_CASE_METHOD(LayoutTest, "a batch of one structure fails the variants of others") {
  const Summary summary = Make(With(Layout::kOne, 30, "out"));
  const std::vector<manifest::Record> records = Records("out");
  std::uint64_t other = 0;
  for (const manifest::Record& record : records) {
    const bool is_same = ShapeOf(record) == ShapeOf(records[0]);
    CHECK((record.status == Status::kOk) == is_same);
    CHECK((record.structure == records[0].structure) == is_same);
    CHECK(record.layout_first == 0u);
    if (!is_same) ++other;
  }
  CHECK(other > 0);
  CHECK(summary.failed == other);
  REQUIRE(summary.findings.size() == 1);
  const diag::Finding& finding = summary.findings[0];
  CHECK(finding.code == diag::Code::kMujocoStructure);
  CHECK(finding.mark.line >= 7);
  REQUIRE(finding.notes.size() == 1);
  CHECK(finding.notes[0].message ==
        std::to_string(other) + " variants have this finding; this is the first");
}

TEST_CASE_METHOD(LayoutTest, "the structure of a batch does not depend on processes and shards") {
  Make(With(Layout::kOne, 60, "whole"));
  for (const std::uint64_t jobs : {1, 7}) {
    Request request = With(Layout::kOne, 60, "jobs" + std::to_string(jobs));
    request.jobs = jobs;
    Make(request);
    CHECK(Bytes("jobs" + std::to_string(jobs)) == Bytes("whole"));
  }
  for (const std::uint64_t shard : {0, 1, 2}) {
    Request request = With(Layout::kOne, 60, "shards");
    request.shard = {shard, 3};
    Make(request);
  }
  diag::Sources sources;
  diag::Findings findings;
  CHECK(Merge(Of(60, "shards").destination, true, sources, findings) == 60u);
  CHECK(ManifestText("shards") == ManifestText("whole"));
}

TEST_CASE_METHOD(LayoutTest, "the structure is that of the first variant that is valid") {
  const auto records = [&](std::uint64_t first) {
    Request request = With(Layout::kOne, 20, "from" + std::to_string(first));
    request.first = first;
    Make(request);
    return Records("from" + std::to_string(first));
  };
  std::set<std::string> kept;  // structures of good variants of batches with another start
  for (const std::uint64_t first : {0, 1, 2, 3, 4, 5}) {
    const std::vector<manifest::Record> batch = records(first);
    CHECK(batch[0].status == Status::kOk);
    CHECK(batch[0].layout_first == first);
    kept.insert(batch[0].structure);
  }
  CHECK(kept.size() == 2);
}

TEST_CASE_METHOD(LayoutTest, "drawing again gives a batch of one structure") {
  Request request = With(Layout::kOne, 30, "out");
  request.variant.on_invalid = OnInvalid::kResample;
  CHECK(Make(request).ok == 30);
  const std::vector<manifest::Record> records = Records("out");
  CHECK(std::ranges::any_of(records, [](const auto& record) { return record.attempt > 0; }));
  for (const manifest::Record& record : records) CHECK(record.structure == records[0].structure);
}

TEST_CASE("a batch whose first variants all fail has no structure") {
  CrateBatch test(
      "mjforge: 1\nname: crate\nparams: {half: -0.2 .. -0.1}\n"
      "parts: [{name: body, type: box, size: [0.1, 0.1, half]}]\n");
  Request request = test.Of(3, "out");
  request.variant.validation = forge::Validation::kLoad;
  request.variant.layout = Layout::kOne;
  const Summary summary = test.Make(request);
  CHECK(summary.failed == 3);
  REQUIRE(summary.findings.size() == 1);
  CHECK(summary.findings[0].code == diag::Code::kModelBadValue);
}

TEST_CASE_METHOD(LayoutTest, "a folder per structure") {
  const std::string output = GENERATE(as<std::string>(), "out", "out/x.tar");
  CHECK(Make(With(Layout::kSplit, 40, output)).ok == 40);
  for (const manifest::Record& record : Records(output)) {
    const std::string name = output::VariantStem("crate", record.index) + ".xml";
    CHECK(record.file == record.structure + "/" + name);
    if (output == "out") CHECK(std::filesystem::exists(folder / "out" / record.file));
  }
  diag::Sources sources;
  diag::Findings findings;
  Verify(Of(40, output).destination.Manifest({}), sources, findings);
  CHECK(findings.empty());
  CHECK(forge::Replay({Of(40, output).destination.Manifest({}).string() + ":7", ""}, sources,
                      findings));
  CHECK(findings.empty());
}

TEST_CASE_METHOD(LayoutTest, "a batch of folders resumes, and shards fill the same folders") {
  Make(With(Layout::kSplit, 60, "whole"));
  Make(With(Layout::kSplit, 25, "resumed"));
  std::filesystem::remove(folder / "resumed" / Records("resumed")[20].file);
  Request request = With(Layout::kSplit, 60, "resumed");
  request.resume = true;
  CHECK(Make(request).resumed == 20);
  CHECK(Bytes("resumed") == Bytes("whole"));
  for (const std::uint64_t shard : {0, 1}) {
    request = With(Layout::kSplit, 60, "shards");
    request.shard = {shard, 2};
    Make(request);
  }
  diag::Sources sources;
  diag::Findings findings;
  CHECK(Merge(Of(60, "shards").destination, true, sources, findings) == 60u);
  CHECK(ManifestText("shards") == ManifestText("whole"));
}

}  // namespace
}  // namespace mjforge::batch
