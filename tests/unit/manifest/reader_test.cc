// Tests of reading manifests.

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

using Outcome = RecordReader::Outcome;

std::string LineOf(std::uint64_t index) {
  Record record;
  record.index = index;
  record.name = "mug";
  record.nbody = 2;
  record.bounds.aabb.min = {-1, -2, -3};
  record.bounds.aabb.max = {1, 2, 0.1};
  std::string line;
  AppendRecord(line, record);
  return line;
}

struct ReaderTest {
  // Returns the outcomes of reading the whole file, and the indices of its records.
  std::pair<std::vector<Outcome>, std::vector<std::uint64_t>> ReadAll(std::string_view text) {
    std::optional<RecordReader> reader =
        RecordReader::Open(folder.Write("manifest.jsonl", text), sources, findings);
    REQUIRE(reader);
    std::pair<std::vector<Outcome>, std::vector<std::uint64_t>> read;
    do {
      read.first.push_back(reader->Next(record));
      if (read.first.back() == Outcome::kRecord) read.second.push_back(record.index);
      is_truncated =
          is_truncated || (read.first.back() == Outcome::kBadLine && reader->is_truncated());
    } while (read.first.back() == Outcome::kRecord || read.first.back() == Outcome::kBadLine);
    bad_lines = std::ranges::count(read.first, Outcome::kBadLine);
    return read;
  }

  harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
  Record record;
  bool is_truncated = false;
  std::ptrdiff_t bad_lines = 0;
};

TEST_CASE_METHOD(ReaderTest, "records come in the order of their lines, with their bounds") {
  const auto [outcomes, indices] = ReadAll(LineOf(3) + LineOf(4));
  CHECK(outcomes == std::vector{Outcome::kRecord, Outcome::kRecord, Outcome::kEnd});
  CHECK(indices == std::vector<std::uint64_t>{3, 4});
  CHECK(record.bounds.aabb.min == Eigen::Vector3d(-1, -2, -3));
  CHECK(record.bounds.aabb.max == Eigen::Vector3d(1, 2, 0.1));
  CHECK(findings.empty());
}

TEST_CASE_METHOD(ReaderTest, "an empty file has no records") {
  CHECK(ReadAll("").first == std::vector{Outcome::kEnd});
  CHECK(findings.empty());
}

TEST_CASE_METHOD(ReaderTest, "a bad line is a finding at its place, and others follow it") {
  const auto [outcomes, indices] = ReadAll(LineOf(0) + "one: two\n" + LineOf(2));
  CHECK(outcomes ==
        std::vector{Outcome::kRecord, Outcome::kBadLine, Outcome::kRecord, Outcome::kEnd});
  CHECK(indices == std::vector<std::uint64_t>{0, 2});
  REQUIRE(findings.size() == 1);
  CHECK(diag::RenderText(findings[0], sources, false) ==
        (folder / "manifest.jsonl").string() +
            ":2:1: error: this line is not a record: it is not a JSON object "
            "[output/bad-manifest]\none: two\n^\n");
  CHECK_FALSE(is_truncated);
}

TEST_CASE_METHOD(ReaderTest, "a line without an end is truncated") {
  ReadAll(LineOf(0) + LineOf(1).substr(0, 20));
  CHECK(is_truncated);
  CHECK(bad_lines == 1);
}

TEST_CASE_METHOD(ReaderTest, "the box of a record has two corners of three numbers") {
  std::string line = LineOf(0);
  line.replace(line.find("[-1,-2,-3]"), 10, "[-1,-2]");
  ReadAll(line);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "this line is not a record: 'aabb' is not a box");
}

TEST_CASE_METHOD(ReaderTest, "of very many bad lines the first have findings") {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "x\n";
  ReadAll(text);
  CHECK(bad_lines == 1000);
  CHECK(findings.size() == RecordReader::kMaxBadLines);
}

TEST_CASE_METHOD(ReaderTest, "reading ends after a million bad lines") {
  const auto [outcomes, indices] = ReadAll(std::string(3'000'000, '\n') + LineOf(0));
  CHECK(outcomes.back() == Outcome::kUnreadable);
  CHECK(bad_lines == RecordReader::kMaxSkippedLines);
  CHECK(indices.empty());
  REQUIRE(findings.size() == RecordReader::kMaxBadLines + 1);
  CHECK(findings[findings.size() - 1].message ==
        "the rest is not read: more than 1000000 lines are not records");
}

TEST_CASE_METHOD(ReaderTest, "what cannot be read is a finding") {
  CHECK_FALSE(RecordReader::Open(folder / "none.jsonl", sources, findings));
  CHECK_FALSE(RecordReader::Open(folder.path(), sources, findings));
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].message ==
        "cannot read '" + (folder / "none.jsonl").string() + "': No such file or directory");
  CHECK(findings[1].message == "cannot read '" + folder.path().string() + "': it is a folder");
}

}  // namespace
}  // namespace mjforge::manifest
