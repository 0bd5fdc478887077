// Tests of encoding tasks and results.

#include "mjforge/batch/message.h"

#include <catch2/catch.hpp>

namespace mjforge::batch {
namespace {

TEST_CASE("a task arrives as it was sent") {
  const Task task{{7, 64, 3}, {{9, true, "took longer"}, {11, false, ""}}};
  const Task read = DecodeTask(Encode(task));
  CHECK(read.chunk.first == 7);
  CHECK(read.chunk.count == 64);
  CHECK(read.chunk.archive == 3);
  REQUIRE(read.quarantined.size() == 2);
  CHECK(read.quarantined[0].index == 9);
  CHECK(read.quarantined[0].too_slow);
  CHECK(read.quarantined[0].how == "took longer");
}

TEST_CASE("a result arrives as it was sent, findings and all") {
  ChunkResult result;
  result.done = 5;
  result.statuses = {Status::kOk, Status::kFailed, Status::kSkipped};
  const std::string segment(100'000, 'x');
  result.lines = std::string_view("a\0b\n", 4);
  result.segment = segment;
  result.variants = {{3, "crate", Status::kOk, 2, "crate_000003.xml"}};
  result.assets = {{"assets/a.png", "/a.png", "12ab"}, {"assets/a.obj", "", "34cd", "v 0 0 0\n"}};
  result.inputs = {"knob.xml"};
  diag::Findings findings;
  diag::Finding& finding = findings.Warn(diag::Code::kModelBadValue, {2, 3, 4}, "message", "hint");
  finding.notes = {{{5, 6, 7}, "note"}};
  finding.index = 8;
  result.findings = {{finding, 12, 99}};
  result.sources = {{2, "knob.xml", "<mujoco/>"}};
  result.files_failed = true;
  result.output_findings.Add(diag::Code::kOutputCannotWrite, {}, "full");
  const auto message = std::make_shared<const std::string>(Encode(result));
  const ChunkResult read = DecodeResult(*message, message);
  CHECK(read.done == 5);
  CHECK(read.statuses == result.statuses);
  CHECK(read.lines == result.lines);
  CHECK(read.segment == result.segment);
  REQUIRE(read.variants.size() == 1);
  CHECK(read.variants[0].place == "crate_000003.xml");
  CHECK(read.assets == result.assets);
  CHECK(read.inputs == result.inputs);
  REQUIRE(read.findings.size() == 1);
  const diag::Finding& copy = read.findings[0].finding;
  CHECK(copy.severity == diag::Severity::kWarning);
  CHECK(copy.code == diag::Code::kModelBadValue);
  CHECK(copy.mark == diag::SourceMark{2, 3, 4});
  CHECK(copy.message == "message");
  CHECK(copy.hint == "hint");
  CHECK(copy.notes.at(0).message == "note");
  CHECK(copy.index == 8u);
  CHECK_FALSE(copy.seed);
  CHECK(read.findings[0].variants == 12);
  CHECK(read.sources.at(0).text == "<mujoco/>");
  CHECK(read.files_failed);
  CHECK(read.output_findings[0].message == "full");
}

TEST_CASE("a message that is cut short is noticed") {
  const std::string message = Encode(Task{{7, 64, 3}, {{9, true, "took longer"}}});
  for (std::size_t size = 0; size < message.size(); ++size)
    CHECK_THROWS(DecodeTask(message.substr(0, size)));
}

}  // namespace
}  // namespace mjforge::batch
