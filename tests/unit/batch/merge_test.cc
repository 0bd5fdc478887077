// Tests of merging shards.

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

  std::optional<std::uint64_t> Merge(bool verify = false) {
    findings.clear();
    return batch::Merge(Of(kCount, "out").destination, verify, sources, findings);
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
        }) == 8);
  CHECK(joined == Bytes("whole"));
  CHECK(Merge() == kCount);  // merging twice
}

TEST_CASE_METHOD(ShardTest, "a shard that is made again takes the merged manifest away") {
  REQUIRE(Merge() == kCount);
  Request again = ShardOf(*this, 2);
  again.resume = true;
  Make(again);
  CHECK(std::filesystem::exists(folder / "out/manifest.jsonl"));
  again.resume = false;
  again.variant.seed = 2;
  Make(again);
  CHECK_FALSE(std::filesystem::exists(folder / "out/manifest.jsonl"));
  CHECK_FALSE(std::filesystem::exists(folder / "out/manifest.seal.json"));
}

TEST_CASE_METHOD(ShardTest, "a shard of another number of shards takes the manifest away, too") {
  REQUIRE(Merge() == kCount);
  Request other = Of(kCount, "out");
  other.shard = {0, 3};
  other.resume = true;
  other.variant.seed = 2;
  Make(other);
  CHECK_FALSE(std::filesystem::exists(folder / "out/manifest.jsonl"));
}

TEST_CASE_METHOD(ShardTest, "shards are not joined over the manifest of another batch") {
  Request whole = Of(kCount, "out");
  whole.variant.seed = 2;
  Make(whole);
  const std::string manifest = ManifestText("out");
  CHECK_FALSE(Merge());
  CHECK(findings[0].message.find("is not of the batch of its shards: seed is '2', not '1'") !=
        std::string::npos);
  CHECK(ManifestText("out") == manifest);
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
  CHECK(Merge(test.Of(kCount, "out/x_%03d.tar.zst").destination, true, sources, findings) ==
        kCount);
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

TEST_CASE_METHOD(ShardTest, "a manifest that is not as it was is noticed") {
  const std::string lines = folder.Read(Manifest(1));
  for (const std::string& other :
       {std::string(), std::string("{}\n"), lines.substr(lines.find('\n') + 1), lines + lines}) {
    folder.Write(Manifest(1), other);
    CHECK_FALSE(Merge());
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].code == diag::Code::kBatchChanged);
    CHECK(findings[0].message.starts_with("'" + (folder / Manifest(1)).string() +
                                          "' was changed: it has "));
  }
  std::string changed = lines;
  changed[lines.size() / 2] ^= 1;
  folder.Write(Manifest(1), changed);
  CHECK_FALSE(Merge());
  CHECK(findings[0].message.ends_with("was changed: its bytes are others"));
}

TEST_CASE_METHOD(ShardTest, "an object that is gone, empty or changed is noticed") {
  const std::string lines = folder.Read(Manifest(3));
  const std::size_t at = lines.find("crate_");
  const std::string file = "out/" + lines.substr(at, lines.find('"', at) - at);
  std::string bytes = folder.Read(file);
  bytes[0] ^= 1;
  folder.Write(file, bytes);
  CHECK(Merge());
  CHECK_FALSE(Merge(true));
  CHECK(findings[0].message.ends_with("was changed: its bytes are others"));
  folder.Write(file, "");
  CHECK_FALSE(Merge());
  CHECK(findings[0].message.ends_with("was changed: it is empty"));
  std::filesystem::remove(folder / file);
  CHECK_FALSE(Merge());
  CHECK(findings[0].message == "'" + (folder / file).string() + "' is missing");
}

TEST_CASE_METHOD(ShardTest, "a shard without a seal is noticed") {
  const auto seal = manifest::SealPathOf(folder / Manifest(2));
  std::filesystem::remove(seal);
  CHECK_FALSE(Merge());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kBatchMissing);
  CHECK(findings[0].message ==
        "shard 2/4 cannot be verified: '" + seal.string() + "': No such file or directory");
}

TEST_CASE("shards of batches of other sizes are not joined") {
  CrateBatch test(kBoxSpec);
  for (std::uint64_t i = 0; i < 2; ++i) {
    Request request = test.Of(100 + i, "out");
    request.shard = {i, 2};
    test.Make(request);
  }
  diag::Sources sources;
  diag::Findings findings;
  CHECK_FALSE(Merge(test.Of(100, "out").destination, false, sources, findings));
  CHECK(findings[0].message.ends_with("belongs to another batch: count is '101', not '100'"));
}

TEST_CASE("where there are no shards, or of two batches, nothing is joined") {
  CrateBatch test(kBoxSpec);
  diag::Sources sources;
  diag::Findings findings;
  const output::Destination destination = test.Of(kCount, "out").destination;
  CHECK_FALSE(Merge(destination, false, sources, findings));
  CHECK(findings[0].code == diag::Code::kYamlCannotRead);
  test.folder.Write("out/manifest-1-of-2.jsonl", "");
  test.folder.Write("out/manifest-1-of-3.jsonl", "");
  findings.clear();
  CHECK_FALSE(Merge(destination, false, sources, findings));
  CHECK(findings[0].code == diag::Code::kBatchDiffers);
}

TEST_CASE("a shard without variants has an empty manifest") {
  CrateBatch test(kBoxSpec);
  for (std::uint64_t i = 0; i < 3; ++i) {
    Request request = test.Of(2, "out");
    request.shard = {i, 3};
    CHECK_FALSE(test.Make(request).files_failed);
  }
  diag::Sources sources;
  diag::Findings findings;
  CHECK(Merge(test.Of(2, "out").destination, false, sources, findings) == 2u);
}

TEST_CASE("a shard of which no variant is valid can be merged") {
  const std::string output = GENERATE("", "/x_%05d.tar");
  CrateBatch test(
      "mjforge: 1\nname: crate\nparams: {height: {cycle: [-1, -1, 1, 1, 1, 1]}}\n"
      "parts: [{name: body, type: box, size: [0.1, 0.1, height]}]\n");
  CHECK(test.Make(test.Of(6, "whole" + output, 2)).failed == 2);
  for (std::uint64_t i = 0; i < 3; ++i) {
    Request request = test.Of(6, "out" + output, 2);
    request.shard = {i, 3};
    CHECK(test.Make(request).failed == (i == 0 ? 2 : 0));
  }
  diag::Sources sources;
  diag::Findings findings;
  CHECK(Merge(test.Of(6, "out" + output, 2).destination, true, sources, findings) == 6u);
  auto merged = test.Bytes("out");
  std::erase_if(merged,
                [](const auto& file) { return file.first.find("-of-") != std::string::npos; });
  CHECK(merged == test.Bytes("whole"));
}

}  // namespace
}  // namespace mjforge::batch
