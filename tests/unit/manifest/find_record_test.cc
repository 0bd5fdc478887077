// Tests of finding one record of a manifest.

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

std::string ShortLineOf(std::uint64_t index) {
  Record record;
  record.index = index;
  record.attempt = index % 7;
  record.name = "mug";
  std::string line;
  AppendRecord(line, record);
  return line;
}

struct FindTest {
  std::optional<Record> Find(const std::filesystem::path& file, std::uint64_t index) {
    findings = {};
    return FindRecord(file, index, sources, findings);
  }
  bool Has(const std::filesystem::path& file, std::uint64_t index) {
    const auto record = Find(file, index);
    return record && record->index == index && record->attempt == index % 7;
  }

  harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
};

TEST_CASE_METHOD(FindTest, "each record of a long manifest is found, compressed or not") {
  // Indices 10, 13, 16, ...; the text is longer than the distance of its cuts.
  bytes::FrameCompressor compressor;
  std::string text;
  std::string frames;
  std::string frame;
  std::vector<std::uint64_t> indices;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    indices.push_back(10 + 3 * i);
    text += ShortLineOf(indices.back());
    frame += ShortLineOf(indices.back());
    if (i % 64 < 63 && i < 4999) continue;
    frames += compressor.Compress(frame);
    frame.clear();
  }
  REQUIRE(text.size() > 4 * 256 * 1024);
  const auto plain = folder.Write("m.jsonl", text);
  const auto compressed = folder.Write("m.jsonl.zst", frames);
  for (std::size_t i = 0; i < indices.size(); i += i < 200 || i > 4900 ? 1 : 37) {
    INFO(indices[i]);
    CHECK(Has(plain, indices[i]));
    CHECK(Has(compressed, indices[i]));
  }
  for (const std::uint64_t index : {0, 9, 11, 15'006, 15'008, 100'000}) {
    CHECK_FALSE(Find(compressed, index));
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].message ==
          "'" + compressed.string() + "' has no record with index " + std::to_string(index));
  }
}

TEST_CASE_METHOD(FindTest, "a record is found although the manifest is not in index order") {
  std::string text;
  for (std::uint64_t i = 0; i < 4000; ++i) text += ShortLineOf((i * 1237 + 5) % 4000);
  const auto file = folder.Write("m.jsonl", text);
  for (const std::uint64_t index : {0, 1, 5, 2000, 3999}) CHECK(Has(file, index));
}

TEST_CASE_METHOD(FindTest, "a manifest with a seal is not read in whole for a record it lacks") {
  std::string text = ShortLineOf(0) + "not a record\n";
  while (text.size() < 1 << 20) text += ShortLineOf(text.size());
  const auto file = folder.Write("m.jsonl", text);
  CHECK_FALSE(Find(file, 1 << 21));
  CHECK(findings[0].message.starts_with("this line is not a record"));
  Seal seal;
  seal.manifest = {"m.jsonl", {text.size(), bytes::ChecksumOf(text)}};
  folder.Write("m.seal.json", SealText(seal));
  CHECK_FALSE(Find(file, 1 << 21));
  CHECK(findings[0].message == "'" + file.string() + "' has no record with index 2097152");
}

TEST_CASE_METHOD(FindTest, "a line that is not a record hides no other record") {
  const auto file = folder.Write("m.jsonl", ShortLineOf(0) + "x\n" + ShortLineOf(2));
  CHECK(Has(file, 0));
  CHECK(Has(file, 2));
  CHECK_FALSE(Find(file, 1));
  REQUIRE(findings.size() == 2);
  CHECK(findings[0].mark.line == 2);
  CHECK(findings[1].message == "'" + file.string() + "' has no record with index 1");
}

}  // namespace
}  // namespace mjforge::manifest
