// Tests of running batches.

#include <catch2/catch.hpp>

#include "crate_batch.h"

#include "mjforge/bytes/bytes.h"

namespace mjforge::batch {
namespace {

using Files = std::vector<std::string>;

TEST_CASE("a batch makes its variants, and tells of them in index order") {
  CrateBatch test(kBoxSpec);
  Request request = test.Of(300, "out");
  request.first = 41;
  std::vector<std::uint64_t> indices;
  Observer observer;
  observer.variant = [&](const FinishedVariant& done) {
    indices.push_back(done.index);
    CHECK(done.place == output::PathInFolder("crate", done.index));
  };
  const Summary summary = test.Make(request, observer);
  CHECK(summary.ok == 300);
  CHECK(summary.failed == 0);
  CHECK(summary.findings.empty());
  REQUIRE(indices.size() == 300);
  for (std::uint64_t i = 0; i < 300; ++i) CHECK(indices[i] == 41 + i);
}

TEST_CASE("the bytes of a batch do not depend on how many processes make it") {
  CrateBatch test(kUnluckySpec);
  Request request = test.Of(700, "one");
  request.jobs = 1;
  test.Make(request);
  const auto one = test.Bytes("one");
  CHECK(one.size() > 300);
  for (const std::uint64_t jobs : {2, 8}) {
    request = test.Of(700, std::to_string(jobs));
    request.jobs = jobs;
    test.Make(request);
    CHECK(test.Bytes(std::to_string(jobs)) == one);
  }
}

TEST_CASE("findings do not depend on how many processes make a batch") {
  CrateBatch test(kUnluckySpec);
  std::vector<std::string> texts;
  for (const std::uint64_t jobs : {1, 5}) {
    Request request = test.Of(500, "out");
    request.jobs = jobs;
    const Summary summary = test.Make(request);
    REQUIRE(summary.findings.size() == 1);
    REQUIRE(summary.findings[0].notes.size() == 1);
    CHECK(summary.findings[0].notes[0].message ==
          std::to_string(summary.failed) + " variants have this finding; this is the first");
    texts.push_back(diag::RenderJson(summary.findings[0], diag::Sources()));
  }
  CHECK(texts[0] == texts[1]);
}

TEST_CASE("skipped variants are not errors") {
  CrateBatch test(kUnluckySpec);
  Request request = test.Of(40, "out");
  request.variant.on_invalid = OnInvalid::kSkip;
  const Summary summary = test.Make(request);
  CHECK(summary.failed == 0);
  CHECK(summary.skipped > 0);
  CHECK(summary.ok + summary.skipped == 40);
  CHECK_FALSE(summary.findings.HasErrors());
}

TEST_CASE("resampling gives every index a variant of its own, whatever else is made") {
  CrateBatch test(kUnluckySpec);
  Request request = test.Of(60, "all");
  request.variant.on_invalid = OnInvalid::kResample;
  const Summary summary = test.Make(request);
  CHECK(summary.ok == 60);
  Request alone = test.Of(1, "one");
  alone.variant.on_invalid = OnInvalid::kResample;
  alone.first = 57;
  test.Make(alone);
  CHECK(test.folder.Read("one/crate_000057.xml") == test.folder.Read("all/crate_000057.xml"));
  CHECK(test.folder.Read("all/manifest.jsonl").find(test.folder.Read("one/manifest.jsonl")) !=
        std::string::npos);
}

TEST_CASE("a batch that is stopped keeps what is done, without a manifest") {
  CrateBatch test(kBoxSpec);
  std::atomic<bool> stop = false;
  Request request = test.Of(20'000, "out");
  request.stop = &stop;
  Observer observer;
  observer.variant = [&](const FinishedVariant&) { stop = true; };
  const Summary summary = test.Make(request, observer);
  CHECK(summary.interrupted);
  CHECK(summary.ok > 0);
  CHECK(summary.ok < 20'000);
  const Files files = test.folder.Files();
  CHECK(std::count(files.begin(), files.end(), "out/manifest.jsonl") == 0);
  CHECK(std::count(files.begin(), files.end(), "out/.manifest.jsonl.part") == 1);
}

TEST_CASE("what cannot be written ends the batch and says where") {
  CrateBatch test(kBoxSpec);
  test.folder.Write("out/crate_000007.xml", "mine");
  const Summary summary = test.Make(test.Of(100, "out"));
  CHECK(summary.files_failed);
  CHECK(summary.done() == 7);
  REQUIRE(summary.findings.size() == 1);
  CHECK(summary.findings[0].code == diag::Code::kOutputExists);
  CHECK(summary.findings[0].index == 7u);
  CHECK(test.folder.Read("out/crate_000007.xml") == "mine");
}

TEST_CASE("the manifest has a line for each variant, failed ones too") {
  CrateBatch test(kUnluckySpec);
  const Summary summary = test.Make(test.Of(20, "out"));
  REQUIRE(summary.failed > 0);
  CHECK(test.Bytes("out").size() == summary.ok + 2);
  const std::string manifest = test.folder.Read("out/manifest.jsonl");
  std::string_view rest = manifest;
  for (std::uint64_t index = 0; index < 20; ++index) {
    std::string why_not;
    const auto record = manifest::ReadRecord(rest.substr(0, rest.find('\n')), why_not);
    INFO(why_not);
    REQUIRE(record);
    CHECK(record->index == index);
    CHECK(record->file.empty() == (record->status == Status::kFailed));
    if (!record->file.empty()) {
      CHECK(bytes::Sha256Of(test.folder.Read("out/" + record->file)) == record->sha256);
    }
    rest.remove_prefix(rest.find('\n') + 1);
  }
  CHECK(rest.empty());
}

TEST_CASE("a batch without a single good variant writes nothing") {
  CrateBatch test(
      "mjforge: 1\nname: crate\nparams: {height: -0.2 .. -0.1}\n"
      "parts: [{name: body, type: box, size: [0.1, 0.1, height]}]\n");
  for (const char* output : {"out", "new/x.tar", "new/x_%05d.tar.zst"}) {
    CHECK(test.Make(test.Of(3, output, 2)).failed == 3);
    CHECK(test.folder.Files() == Files{"crate.yaml"});
  }
  CHECK_FALSE(std::filesystem::exists(test.folder / "out"));
  CHECK_FALSE(std::filesystem::exists(test.folder / "new"));
}

TEST_CASE("files past the ten thousandth go to folders of their own") {
  CrateBatch test(kBoxSpec);
  Request request = test.Of(4, "out");
  request.first = 9'998;
  test.Make(request);
  CHECK(test.folder.Files() == Files{"crate.yaml", "out/0010000/crate_010000.xml",
                                     "out/0010000/crate_010001.xml", "out/crate_009998.xml",
                                     "out/crate_009999.xml", "out/manifest.jsonl",
                                     "out/manifest.seal.json"});
}

TEST_CASE("files that stay the same keep their time where that is asked for") {
  CrateBatch test(kBoxSpec);
  Request request = test.Of(3, "out");
  request.if_changed = true;
  test.Make(request);
  const auto old = std::filesystem::file_time_type(std::chrono::seconds(1));
  for (const std::string& file : test.folder.Files())
    std::filesystem::last_write_time(test.folder / file, old);
  test.folder.Write("out/crate_000001.xml", test.folder.Read("out/crate_000002.xml"));
  test.Make(request);
  CHECK(std::filesystem::last_write_time(test.folder / "out/crate_000000.xml") == old);
  CHECK(std::filesystem::last_write_time(test.folder / "out/manifest.jsonl") == old);
  CHECK(std::filesystem::last_write_time(test.folder / "out/crate_000001.xml") != old);
}

TEST_CASE("as a target of Make, a batch with a failed variant gets no name") {
  CrateBatch test(kUnluckySpec);
  for (const std::string output : {"out", "x.tar"}) {
    Request request = test.Of(20, output);
    request.all_or_nothing = true;
    CHECK(test.Make(request).failed > 0);
  }
  for (const std::string& file : test.folder.Files()) {
    CHECK_FALSE(file.ends_with("/manifest.jsonl"));
    CHECK(file != "x.tar");
  }
}

}  // namespace
}  // namespace mjforge::batch
