#include <catch2/catch.hpp>

#include "loaded_recipe.h"

namespace mjforge::forge {
namespace {

using Files = std::vector<std::string>;

struct BatchTest {
  explicit BatchTest(const char* text) : loaded(text) { options.seed = 1; }

  Summary Make(const Batch& batch, const Sink& sink = {}) {
    Generator generator(loaded.recipe, loaded.sources, options, nullptr);
    return MakeBatch(generator, batch, sink);
  }
  Summary MakeInto(const std::filesystem::path& folder, const Batch& batch) {
    Generator generator(loaded.recipe, loaded.sources, options, nullptr);
    return MakeFolder(generator, batch, folder, false, {});
  }

  LoadedRecipe loaded;
  Options options;
};

Batch Of(std::uint64_t first, std::uint64_t count) {
  Batch batch;
  batch.first = first;
  batch.count = count;
  return batch;
}

TEST_CASE("a batch makes its variants in index order") {
  BatchTest test(kBoxSpec);
  std::vector<std::uint64_t> indices;
  const Summary summary = test.Make(Of(41, 3), [&](const Variant& variant, diag::Findings&) {
    indices.push_back(variant.record.index);
    return true;
  });
  CHECK(indices == std::vector<std::uint64_t>{41, 42, 43});
  CHECK(summary.ok == 3);
  CHECK(summary.failed == 0);
}

TEST_CASE("a failed variant costs only itself and is reported once with the others") {
  BatchTest test(kUnluckySpec);
  const Summary summary = test.Make(Of(0, 40));
  CHECK(summary.ok + summary.failed == 40);
  CHECK(summary.ok > 0);
  REQUIRE(summary.failed > 1);
  REQUIRE(summary.findings.size() == 1);
  REQUIRE(summary.findings[0].notes.size() == 1);
  CHECK(summary.findings[0].notes[0].message ==
        std::to_string(summary.failed) + " variants have this finding; this is the first");
}

TEST_CASE("skipped variants are not errors") {
  BatchTest test(kUnluckySpec);
  Batch batch = Of(0, 40);
  batch.on_invalid = OnInvalid::kSkip;
  std::uint64_t seen = 0;
  const Summary summary = test.Make(batch, [&](const Variant& variant, diag::Findings&) {
    if (variant.record.status == "skipped") ++seen;
    return true;
  });
  CHECK(summary.failed == 0);
  CHECK(summary.skipped == seen);
  CHECK(seen > 0);
  CHECK_FALSE(summary.findings.HasErrors());
}

TEST_CASE("a batch that is stopped keeps what is done") {
  BatchTest test(kBoxSpec);
  const harness::TemporaryFolder folder;
  std::atomic<bool> stop = false;
  Batch batch = Of(0, 100);
  batch.stop = &stop;
  Generator generator(test.loaded.recipe, test.loaded.sources, test.options, nullptr);
  const Summary summary =
      MakeFolder(generator, batch, folder / "out", false, [&](const Variant& variant) {
        if (variant.record.index == 1) stop = true;
      });
  CHECK(summary.interrupted);
  CHECK(summary.ok == 2);
  CHECK(folder.Files() ==
        Files{"out/crate_000000.xml", "out/crate_000001.xml", "out/manifest.jsonl"});
}

TEST_CASE("a sink that fails ends the batch") {
  BatchTest test(kBoxSpec);
  int calls = 0;
  const Summary summary = test.Make(Of(0, 10), [&](const Variant&, diag::Findings& findings) {
    findings.Add(diag::Code::kOutputCannotWrite, {}, "full");
    ++calls;
    return false;
  });
  CHECK(calls == 1);
  CHECK(summary.output_failed);
  REQUIRE(summary.findings.size() == 1);
  CHECK(summary.findings[0].message == "full");
}

TEST_CASE("the manifest has a line for each variant, failed ones too") {
  BatchTest test(kUnluckySpec);
  const harness::TemporaryFolder folder;
  const Summary summary = test.MakeInto(folder / "out", Of(0, 20));
  REQUIRE(summary.failed > 0);
  CHECK(folder.Files().size() == summary.ok + 1);
  const std::string manifest = folder.Read("out/manifest.jsonl");
  std::string_view rest = manifest;
  for (std::uint64_t index = 0; index < 20; ++index) {
    std::string why_not;
    const auto record = output::ReadRecord(rest.substr(0, rest.find('\n')), why_not);
    INFO(why_not);
    REQUIRE(record);
    CHECK(record->index == index);
    CHECK(record->file.empty() == (record->status == "failed"));
    if (!record->file.empty()) {
      CHECK(output::Sha256(folder.Read("out/" + record->file)) == record->sha256);
    }
    rest.remove_prefix(rest.find('\n') + 1);
  }
  CHECK(rest.empty());
}

TEST_CASE("a batch without a single good variant writes nothing") {
  BatchTest test(
      "mjforge: 1\nname: crate\nparams: {height: -0.2 .. -0.1}\n"
      "parts: [{name: body, type: box, size: [0.1, 0.1, height]}]\n");
  const harness::TemporaryFolder folder;
  const Summary summary = test.MakeInto(folder / "out", Of(0, 3));
  CHECK(summary.failed == 3);
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_CASE("the same batch again gives the same bytes, in another folder, too") {
  BatchTest test(kBoxSpec);
  const harness::TemporaryFolder folder;
  test.MakeInto(folder / "a", Of(0, 3));
  const std::string manifest = folder.Read("a/manifest.jsonl");
  const std::string object = folder.Read("a/crate_000002.xml");
  CHECK(test.MakeInto(folder / "a", Of(0, 3)).ok == 3);
  CHECK(test.MakeInto(folder / "b/c", Of(0, 3)).ok == 3);
  CHECK(folder.Read("a/manifest.jsonl") == manifest);
  CHECK(folder.Read("b/c/manifest.jsonl") == manifest);
  CHECK(folder.Read("b/c/crate_000002.xml") == object);
}

}  // namespace
}  // namespace mjforge::forge
