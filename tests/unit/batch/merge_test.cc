#include <catch2/catch.hpp>

#include "crate_batch.h"

namespace mjforge::batch {
namespace {

constexpr std::uint64_t kCount = 100;

Request ShardOf(const CrateBatch& test, std::uint64_t index, const std::string& output = "out") {
  Request request = test.Of(kCount, output);
  request.shard = {index, 4};
  return request;
}

struct ShardTest : CrateBatch {
  ShardTest() : CrateBatch(kUnluckySpec) {
    for (std::uint64_t i = 0; i < 4; ++i) Make(ShardOf(*this, i));
  }

  std::optional<std::uint64_t> Merge() {
    findings.clear();
    return batch::Merge(Of(kCount, "out").destination, sources, findings);
  }
  std::string Manifest(int index) const {
    return "out/manifest-0000" + std::to_string(index) + "-of-00004.jsonl";
  }

  diag::Sources sources;
  diag::Findings findings;
};

TEST_CASE_METHOD(ShardTest, "shards joined are the batch as one run makes it") {
  Make(Of(kCount, "whole"));
  CHECK_FALSE(std::filesystem::exists(folder / "out/manifest.jsonl"));
  CHECK(Merge() == kCount);
  auto joined = Bytes("out");
  CHECK(std::erase_if(joined, [](const auto& file) {
          return file.first.find("-of-") != std::string::npos;
        }) == 4);
  CHECK(joined == Bytes("whole"));
  CHECK(Merge() == kCount);  // again
}

TEST_CASE("shards of a series joined are the series as one run makes it") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(kCount, "whole/x_%03d.tar.zst"));
  for (const std::uint64_t index : {3, 0, 2, 1}) {
    Request request = test.Of(kCount, "out/x_%03d.tar.zst");
    request.shard = {index, 4};
    test.Make(request);
  }
  diag::Sources sources;
  diag::Findings findings;
  CHECK(Merge(test.Of(kCount, "out/x_%03d.tar.zst").destination, sources, findings) == kCount);
  auto joined = test.Bytes("out");
  std::erase_if(joined,
                [](const auto& file) { return file.first.find("-of-") != std::string::npos; });
  CHECK(joined == test.Bytes("whole"));
}

TEST_CASE_METHOD(ShardTest, "a shard that is missing is named") {
  std::filesystem::remove(folder / Manifest(2));
  CHECK_FALSE(Merge());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kBatchMissing);
  CHECK(findings[0].message ==
        "shard 2/4 is missing: there is no '" + (folder / Manifest(2)).string() + "'");
  CHECK(findings[0].hint == "make it with --shard 2/4 --resume");
}

TEST_CASE_METHOD(ShardTest, "a shard of another batch is noticed") {
  Request request = ShardOf(*this, 1);
  request.variant.seed = 5;
  Make(request);
  CHECK_FALSE(Merge());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kBatchDiffers);
  CHECK(findings[0].message.ends_with("belongs to another batch: seed is '5', not '1'"));
  CHECK_FALSE(std::filesystem::exists(folder / "out/manifest.jsonl"));
}

TEST_CASE_METHOD(ShardTest, "a gap and a variant that is there twice are noticed") {
  const std::string lines = folder.Read(Manifest(1));
  const std::size_t end = lines.find('\n') + 1;
  folder.Write(Manifest(1), lines.substr(end));
  CHECK_FALSE(Merge());
  CHECK(findings[0].message.ends_with("has index 26; expected 25"));
  folder.Write(Manifest(1), lines.substr(0, end) + lines);
  CHECK_FALSE(Merge());
  CHECK(findings[0].message.ends_with("has index 25; expected 26"));
}

TEST_CASE_METHOD(ShardTest, "an object that is gone is noticed") {
  const std::string lines = folder.Read(Manifest(3));
  const std::size_t at = lines.find("crate_");
  const std::string file = "out/" + lines.substr(at, lines.find('"', at) - at);
  std::filesystem::remove(folder / file);
  CHECK_FALSE(Merge());
  CHECK(findings[0].message.starts_with("'" + (folder / file).string() + "', which holds variant"));
}

TEST_CASE_METHOD(ShardTest, "a manifest that is damaged is noticed") {
  folder.Write(Manifest(0), "{}\n");
  CHECK_FALSE(Merge());
  CHECK(findings[0].code == diag::Code::kOutputBadManifest);
}

TEST_CASE("where there are no shards, or of two batches, nothing is joined") {
  CrateBatch test(kBoxSpec);
  diag::Sources sources;
  diag::Findings findings;
  const output::Destination destination = test.Of(kCount, "out").destination;
  CHECK_FALSE(Merge(destination, sources, findings));
  CHECK(findings[0].code == diag::Code::kYamlCannotRead);
  test.folder.Write("out/manifest-1-of-2.jsonl", "");
  test.folder.Write("out/manifest-1-of-3.jsonl", "");
  findings.clear();
  CHECK_FALSE(Merge(destination, sources, findings));
  CHECK(findings[0].code == diag::Code::kBatchDiffers);
}

TEST_CASE("a shard without variants has an empty manifest") {
  CrateBatch test(kBoxSpec);
  for (std::uint64_t i = 0; i < 3; ++i) {
    Request request = test.Of(2, "out");
    request.shard = {i, 3};
    CHECK_FALSE(test.Make(request).output_failed);
  }
  diag::Sources sources;
  diag::Findings findings;
  CHECK(Merge(test.Of(2, "out").destination, sources, findings) == 2u);
}

}  // namespace
}  // namespace mjforge::batch
