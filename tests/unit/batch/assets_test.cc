// Tests of assets in batches: copies, changes, and assets of earlier runs.

#include <cstring>

#include <catch2/catch.hpp>

#include "crate_batch.h"

namespace mjforge::batch {
namespace {

struct AssetsTest : CrateBatch {
  explicit AssetsTest(const std::string& picture = "wood.png") : CrateBatch(SpecWith(picture)) {
    folder.Write(picture, Png('a'));
  }

  static std::string SpecWith(const std::string& picture) {
    std::string spec = kWoodenSpec;
    return spec.replace(spec.find("wood.png"), std::strlen("wood.png"), picture);
  }

  // Returns the finding that ended the batch; empty if the batch was made.
  std::string ErrorOf(const Request& request) {
    const Summary summary = Make(request);
    return summary.files_failed ? summary.findings[0].message : std::string();
  }
  Request Shard(std::uint64_t index, const std::string& output) const {
    Request request = Of(20, output);
    request.shard = {index, 2};
    return request;
  }
  // Makes a batch, interrupts it after the variant `last`, and returns the request that resumes it.
  Request Interrupted(Request request, std::uint64_t last) {
    std::atomic<bool> stop = false;
    request.stop = &stop;
    Observer observer;
    observer.variant = [&](const FinishedVariant& done) { stop = done.index >= last; };
    REQUIRE(Make(request, observer).interrupted);
    request.stop = nullptr;
    request.resume = true;
    return request;
  }
  bool IsGood(const std::string& what) {
    diag::Sources sources;
    findings.clear();
    Verify(folder / what, sources, findings);
    return findings.empty();
  }

  diag::Findings findings;
};

TEST_CASE_METHOD(AssetsTest, "records and seal say what the objects refer to") {
  const std::string output = GENERATE("out", "out/x.tar");
  Make(Of(3, output));
  const std::string expected =
      R"("assets":{"assets/wood.png":")" + bytes::Sha256Of(Png('a')) + R"("})";
  const std::string name = output == "out" ? "out/" : "out/x.";
  CHECK(folder.Read(name + "manifest.jsonl").find(expected) != std::string::npos);
  CHECK(folder.Read(name + "manifest.seal.json").find(expected) != std::string::npos);
  if (output == "out") return;
  const auto member = output::ReadMember(folder / "out/x.tar", "crate_000001.json", findings);
  REQUIRE(member);
  CHECK(member->find(expected) != std::string::npos);
}

TEST_CASE_METHOD(AssetsTest, "an asset of the user's is not replaced, by a shard neither") {
  folder.Write("out/assets/wood.png", Png('u'));
  const bool of_shards = GENERATE(false, true);
  const Request request = of_shards ? Shard(1, "out") : Of(20, "out");
  CHECK(ErrorOf(request).find("exists, and its content differs from") != std::string::npos);
  CHECK(folder.Read("out/assets/wood.png") == Png('u'));
  Request forced = request;
  forced.force = true;
  CHECK(ErrorOf(forced).empty());
  CHECK(folder.Read("out/assets/wood.png") == Png('a'));
}

TEST_CASE_METHOD(AssetsTest, "an asset of another batch is not replaced in its folder") {
  Make(Of(20, "out"));
  std::string spec = kWoodenSpec;
  spec.replace(spec.find("crate"), 5, "chest");
  folder.Write("chest.yaml", spec);
  folder.Write("wood.png", Png('b'));
  diag::Sources sources;
  const auto recipe = forge::LoadRecipe((folder / "chest.yaml").string(), {}, sources, findings);
  REQUIRE(recipe);
  const Summary summary = Run(*recipe, sources, Of(20, "out"), {});
  CHECK(summary.files_failed);
  CHECK(folder.Read("out/assets/wood.png") == Png('a'));
}

TEST_CASE_METHOD(AssetsTest, "the same batch made again has the asset as it is now") {
  const bool of_shards = GENERATE(false, true);
  const Request request = of_shards ? Shard(0, "out") : Of(20, "out");
  Make(request);
  folder.Write("wood.png", Png('b'));
  CHECK(ErrorOf(request).empty());
  CHECK(folder.Read("out/assets/wood.png") == Png('b'));
  folder.Write("wood.png", Png('c'));
  CHECK(ErrorOf(request).empty());
  CHECK(IsGood(request.destination.Manifest(request.shard).string()));
}

TEST_CASE_METHOD(AssetsTest, "what a killed run copied is known as its own") {
  Make(Of(2000, "whole"));
  Request request = Of(2000, "out");
  std::atomic<bool> stop = false;
  request.stop = &stop;
  Observer observer;
  observer.variant = [&](const FinishedVariant&) { stop = true; };
  REQUIRE(Make(request, observer).interrupted);
  request.stop = nullptr;
  folder.Write("wood.png", Png('b'));
  SECTION("to be replaced where all is made anew") {
    CHECK(ErrorOf(request).empty());
    CHECK(folder.Read("out/assets/wood.png") == Png('b'));
  }
  SECTION("but not where what it made is kept") {
    request.resume = true;
    CHECK_FALSE(ErrorOf(request).empty());
    request.force = true;
    CHECK(ErrorOf(request).find("was changed while the batch was made") != std::string::npos);
  }
}

TEST_CASE_METHOD(AssetsTest, "a damaged asset is restored where its objects are kept") {
  Request request = Of(20, "out");
  Make(request);
  const auto whole = Bytes("out");
  request.resume = true;
  std::filesystem::remove(folder / "out/crate_000011.xml");
  folder.Write("out/assets/wood.png", Png('u'));
  CHECK(ErrorOf(request).empty());
  CHECK(Bytes("out") == whole);
}

TEST_CASE_METHOD(AssetsTest, "an asset of kept objects is noted again when a batch is resumed") {
  Request request = Of(2000, "out");
  request.jobs = 1;
  std::atomic<bool> stop = false;
  request.stop = &stop;
  Observer observer;
  observer.variant = [&](const FinishedVariant&) { stop = true; };
  REQUIRE(Make(request, observer).interrupted);
  request.stop = nullptr;
  request.resume = true;
  std::filesystem::remove(folder / "out/crate_000011.xml");  // in the middle of the first chunk
  folder.Write("wood.png", Png('b'));
  CHECK(ErrorOf(request).find("exists, and its content differs from") != std::string::npos);
  CHECK(folder.Read("out/assets/wood.png") == Png('a'));
  folder.Write("wood.png", Png('a'));
  CHECK(ErrorOf(request).empty());
  CHECK(IsGood("out"));
}

TEST_CASE_METHOD(AssetsTest, "a series has one version of an asset") {
  const Request request = Interrupted(Of(2000, "out/x_%d.tar", 500), 701);
  folder.Write("wood.png", Png('b'));
  CHECK(ErrorOf(request) == "'assets/wood.png' was changed while the batch was made");
  folder.Write("wood.png", Png('a'));
  CHECK(ErrorOf(request).empty());
  CHECK(IsGood("out"));
  Make(Of(2000, "whole/x_%d.tar", 500));
  CHECK(Bytes("out") == Bytes("whole"));
}

/// An asset whose name has a hash of its content.
struct FarAssetsTest : AssetsTest {
  FarAssetsTest() : AssetsTest("pictures/wood.png") {}
};

TEST_CASE_METHOD(FarAssetsTest, "a resumed batch has one version of an asset, whatever its name") {
  const std::string output = GENERATE("out", "out/x.tar");
  const Request request = Interrupted(Of(2000, output), 701);
  folder.Write("pictures/wood.png", Png('b'));
  const std::string file = (folder / "pictures/wood.png").string();
  CHECK(ErrorOf(request) == "'" + file + "' was changed while the batch was made");
  folder.Write("pictures/wood.png", Png('a'));
  CHECK(ErrorOf(request).empty());
  CHECK(IsGood("out"));
}

TEST_CASE_METHOD(AssetsTest, "a lost or changed asset is found, and made again") {
  Request request = Of(20, "out");
  Make(request);
  const std::string change = GENERATE("gone", "empty");
  if (change == "gone") std::filesystem::remove(folder / "out/assets/wood.png");
  if (change == "empty") folder.Write("out/assets/wood.png", "");
  CHECK_FALSE(IsGood("out"));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message.find("assets/wood.png' ") != std::string::npos);
  request.resume = true;
  request.force = change == "empty";
  CHECK(ErrorOf(request).empty());
  CHECK(IsGood("out"));
}

TEST_CASE_METHOD(AssetsTest, "shards with different versions of an asset are not joined") {
  const std::string output = GENERATE("out", "out/x_%d.tar");
  Make(Shard(0, output));
  folder.Write("wood.png", Png('b'));
  Request second = Shard(1, output);
  if (output == "out") {
    CHECK(ErrorOf(second).find("exists") != std::string::npos);
    second.force = true;
  }
  CHECK(ErrorOf(second).empty());
  diag::Sources sources;
  CHECK_FALSE(Merge(Of(20, output).destination, false, sources, findings));
  REQUIRE_FALSE(findings.empty());
  CHECK(findings[0].code == diag::Code::kBatchDiffers);
  CHECK(findings[0].message.ends_with("'assets/wood.png' has other bytes"));
}

}  // namespace
}  // namespace mjforge::batch
