// Tests of verifying batches.

#include <catch2/catch.hpp>

#include "crate_batch.h"

namespace mjforge::batch {
namespace {

struct VerifyTest : CrateBatch {
  VerifyTest() : CrateBatch(kUnluckySpec) {}

  bool IsGood(const std::string& what) {
    findings.clear();
    verified = Verify(folder / what, sources, findings);
    return !findings.HasErrors();
  }

  diag::Sources sources;
  diag::Findings findings;
  VerifyResult verified;
};

TEST_CASE_METHOD(VerifyTest, "what was just made is as it was") {
  const Summary summary = Make(Of(100, "out"));
  Make(Of(100, "series/x_%d.tar.zst", 30));
  CHECK(IsGood("out"));
  CHECK(verified.variants == 100);
  CHECK(verified.files == summary.ok + 1);
  CHECK(IsGood("series"));
  CHECK(verified.files == 5);
  CHECK(IsGood("series/x.manifest.jsonl.zst"));
  CHECK(IsGood("series/x.manifest.seal.json"));
  CHECK(IsGood("series/x_2.tar.zst"));
  CHECK(verified.files == 1);
}

TEST_CASE_METHOD(VerifyTest, "each file that is missing, short or changed is named") {
  const std::string output = GENERATE("", "/x.tar", "/x_%d.tar.zst");
  Make(Of(50, "out" + output, 30));
  for (const auto& [name, bytes] : Bytes("out")) {
    INFO(name);
    std::string changed = bytes;
    changed[bytes.size() / 2] ^= 1;
    for (const std::string& other : {std::string(), bytes.substr(1), changed}) {
      folder.Write("out/" + name, other);
      CHECK_FALSE(IsGood("out"));
      CHECK(findings[0].message.find(name) != std::string::npos);
    }
    std::filesystem::remove(folder / "out" / name);
    CHECK_FALSE(IsGood("out"));
    CHECK(findings[0].code == diag::Code::kBatchMissing);
    CHECK(findings[0].message.find(name) != std::string::npos);
    folder.Write("out/" + name, bytes);
  }
  CHECK(IsGood("out"));
}

TEST_CASE_METHOD(VerifyTest, "a batch without a seal is not good") {
  folder.Write("empty/x.tar", "");
  CHECK_FALSE(IsGood("empty"));
  CHECK(findings[0].message.ends_with("empty' has no manifest"));
  CHECK_FALSE(IsGood("empty/x.tar"));
  CHECK_FALSE(IsGood("none"));
  CHECK(findings[0].message ==
        "cannot read '" + (folder / "none").string() + "': there is no such file");
  Make(Of(10, "out"));
  std::filesystem::rename(folder / "out/manifest.jsonl", folder / "out/.manifest.jsonl.part");
  CHECK_FALSE(IsGood("out"));
  CHECK(findings[0].message.ends_with(".manifest.jsonl.part' is of a batch that is not done"));
  folder.Write("packed/.x.manifest.jsonl.zst.part", "");
  CHECK_FALSE(IsGood("packed"));
  CHECK(findings[0].message.ends_with(".jsonl.zst.part' is of a batch that is not done"));
  folder.Write("lost/x.manifest.jsonl.zst", "");
  CHECK_FALSE(IsGood("lost"));
  CHECK(findings[0].message.find("x.manifest.jsonl.zst' cannot be verified: ") !=
        std::string::npos);
}

TEST_CASE_METHOD(VerifyTest, "a series is verified by its name, also without a seal") {
  Request request = Of(100, "out/x_%d.tar.zst", 30);
  Make(request);
  Make(Of(20, "out/y_%d.tar.zst", 10));
  CHECK(IsGood("out/x_%d.tar.zst"));
  CHECK(verified.variants == 100);
  CHECK(verified.files == 5);
  folder.Write("out/x_1.tar.zst", "");
  CHECK_FALSE(IsGood("out/x_%d.tar.zst"));
  CHECK(findings[0].message.find("x_1.tar.zst' was changed: it has 0 bytes") != std::string::npos);
  CHECK(IsGood("out/y_%d.tar.zst"));
  std::filesystem::remove(folder / "out/y.manifest.seal.json");
  for (const char* name : {"out/y_%d.tar.zst", "out/y_1.tar.zst"}) {
    CHECK_FALSE(IsGood(name));
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].code == diag::Code::kBatchMissing);
    CHECK(findings[0].hint.starts_with("run the command that made it again with --resume"));
  }
  request.destination.path = folder / "shards/x_%d.tar";
  request.destination.format = output::ArchiveFormat::kTar;
  for (request.shard = {.index = 0, .count = 2}; request.shard.index < 2; ++request.shard.index)
    Make(request);
  CHECK(IsGood("shards/x_%d.tar"));
  CHECK(verified.variants == 100);
}

TEST_CASE_METHOD(VerifyTest, "an archive is not taken for a series of the same name") {
  Make(Of(4, "out/x.tar"));
  CHECK_FALSE(IsGood("out/x_%d.tar"));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message.ends_with(
      "x.manifest.jsonl' is the manifest of 'x.tar', not of 'x_%d.tar'"));
}

TEST_CASE_METHOD(VerifyTest, "a batch of which a shard was not made is not good") {
  for (const std::string output : {"out", "series/x_%02d.tar.zst"}) {
    const std::string folder_name = output.substr(0, output.find('/'));
    INFO(output);
    Request request = Of(100, output);
    for (const std::uint64_t index : {0, 3}) {
      request.shard = {index, 4};
      Make(request);
    }
    for (const std::string& name : {folder_name, output}) {
      CHECK_FALSE(IsGood(name));
      REQUIRE(findings.size() == 2);
      CHECK(findings[0].code == diag::Code::kBatchMissing);
      CHECK(findings[0].message == "shard 1/4 is missing: there is no '" +
                                       request.destination.Manifest({1, 4}).string() + "'");
      CHECK(findings[1].hint == "make it with --shard 2/4 --resume");
    }
    CHECK(IsGood(request.destination.Manifest({3, 4}).lexically_relative(folder / ".")));
    for (request.shard.index = 1; request.shard.index < 3; ++request.shard.index) Make(request);
    CHECK(IsGood(folder_name));
  }
}

TEST_CASE_METHOD(VerifyTest, "shards that were merged are not counted again") {
  Request request = Of(100, "out");
  for (request.shard = {.index = 0, .count = 2}; request.shard.index < 2; ++request.shard.index)
    Make(request);
  CHECK(IsGood("out"));
  const VerifyResult apart = verified;
  CHECK(apart.variants == 100);
  REQUIRE(Merge(request.destination, false, sources, findings) == 100);
  CHECK(IsGood("out"));
  CHECK(verified.variants == 100);
  CHECK(verified.files == apart.files - 1);  // one manifest in place of two
}

TEST_CASE_METHOD(VerifyTest, "shards beside the manifest of other indices are verified") {
  Make(Of(20, "out"));
  Request request = Of(100, "out");
  request.first = 20;
  for (request.shard = {.index = 0, .count = 2}; request.shard.index < 2; ++request.shard.index)
    Make(request);
  CHECK(IsGood("out"));
  CHECK(verified.variants == 120);
  std::string last;
  for (const auto& [name, bytes] : Bytes("out")) {
    if (name.ends_with(".xml")) last = name;
  }
  std::filesystem::remove(folder / "out" / last);
  CHECK_FALSE(IsGood("out"));
}

TEST_CASE_METHOD(VerifyTest, "merged shards are verified where the merged seal is lost") {
  Request request = Of(100, "out/x_%d.tar", 30);
  for (request.shard = {.index = 0, .count = 2}; request.shard.index < 2; ++request.shard.index)
    Make(request);
  REQUIRE(Merge(request.destination, false, sources, findings) == 100);
  std::filesystem::remove(folder / "out/x.manifest.seal.json");
  CHECK(IsGood("out/x_%d.tar"));
  CHECK(verified.variants == 100);
  CHECK_FALSE(IsGood("out"));
}

TEST_CASE_METHOD(VerifyTest, "shards of different batches are no batch") {
  Request request = Of(100, "out");
  request.shard = {.index = 0, .count = 2};
  Make(request);
  request.shard.index = 1;
  const std::string difference = GENERATE("seed is '2', not '1'", "count is '80', not '100'");
  if (difference[0] == 's') request.variant.seed = 2;
  if (difference[0] == 'c') request.count = 80;
  Make(request);
  CHECK_FALSE(IsGood("out"));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kBatchDiffers);
  CHECK(findings[0].message == "'" + request.destination.Manifest(request.shard).string() +
                                   "' belongs to another batch: " + difference);
}

TEST_CASE_METHOD(VerifyTest, "a manifest that is left over from another batch is not good") {
  Make(Of(10, "out/x.tar.zst"));
  Request plain = Of(10, "out/x.tar");
  plain.force = true;
  Make(plain);
  CHECK(IsGood("out"));
  CHECK(IsGood("out/x.manifest.seal.json"));
  CHECK_FALSE(IsGood("out/x.manifest.jsonl.zst"));
  CHECK(findings[0].message.find("which names 'x.manifest.jsonl'") != std::string::npos);
}

TEST_CASE_METHOD(VerifyTest, "many faults are counted") {
  Make(Of(200, "out"));
  for (const auto& [name, bytes] : Bytes("out")) {
    if (name.ends_with(".xml")) folder.Write("out/" + name, "x");
  }
  CHECK_FALSE(IsGood("out"));
  CHECK(findings.size() == kMaxFindings);
  CHECK(verified.more_findings > 0);
}

}  // namespace
}  // namespace mjforge::batch
