#include "mjforge/batch/sink.h"

#include <catch2/catch.hpp>

#include "crate_batch.h"

namespace mjforge::batch {
namespace {

// Stops the batch once `count` variants are done.
Summary MakeUpTo(CrateBatch& test, Request request, std::uint64_t count) {
  std::atomic<bool> stop = false;
  request.stop = &stop;
  request.jobs = 1;  // with two, all of it may be made before the first chunk is taken
  Watch watch;
  watch.variant = [&](const Done& done) {
    if (done.index + 1 >= count) stop = true;
  };
  return test.Make(request, watch);
}

Request Resuming(Request request) {
  request.resume = true;
  return request;
}

TEST_CASE("a batch that was stopped is gone on with to the same bytes") {
  const auto [spec, output] = GENERATE(table<const char*, const char*>({
      {kBoxSpec, ""},
      {kUnluckySpec, ""},
      {kBoxSpec, "/x.tar"},
      {kUnluckySpec, "/x.tar.zst"},
      {kBoxSpec, "/x_%05d.tar"},
      {kUnluckySpec, "/x_%05d.tar.zst"},
  }));
  INFO(output);
  CrateBatch test(spec);
  constexpr std::uint64_t kCount = 3000;
  test.Make(test.Of(kCount, std::string("whole") + output, 700));
  const Request request = test.Of(kCount, std::string("broken") + output, 700);
  const Summary first = MakeUpTo(test, request, 1000);
  REQUIRE(first.interrupted);
  REQUIRE(first.done() < kCount);
  CHECK(test.Bytes("broken") != test.Bytes("whole"));
  const Summary second = MakeUpTo(test, Resuming(request), 2000);
  CHECK(second.kept > 0);
  const Summary last = test.Make(Resuming(request));
  CHECK(last.kept >= second.kept);
  CHECK(last.done() == kCount);
  CHECK(test.Bytes("broken") == test.Bytes("whole"));
  // And once more, with nothing left to do.
  const Summary again = test.Make(Resuming(request));
  CHECK(again.kept == kCount);
  CHECK(test.Bytes("broken") == test.Bytes("whole"));
}

TEST_CASE("files that are gone or were changed are made again") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(100, "out"));
  const auto whole = test.Bytes("out");
  std::filesystem::remove(test.folder / "out/crate_000020.xml");
  test.folder.Write("out/crate_000050.xml", test.folder.Read("out/crate_000051.xml"));
  const Summary summary = test.Make(Resuming(test.Of(100, "out")));
  CHECK(summary.kept == 20);
  CHECK(summary.ok == 100);
  CHECK(test.Bytes("out") == whole);
}

TEST_CASE("an archive that is gone is made again") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(100, "out/x_%d.tar", 30));
  const auto whole = test.Bytes("out");
  std::filesystem::remove(test.folder / "out/x_2.tar");
  test.Make(Resuming(test.Of(100, "out/x_%d.tar", 30)));
  CHECK(test.Bytes("out") == whole);
}

TEST_CASE("a finished batch can be gone on with to a larger one") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(50, "out"));
  const Summary summary = test.Make(Resuming(test.Of(80, "out")));
  CHECK(summary.kept == 50);
  test.Make(test.Of(80, "whole"));
  CHECK(test.Bytes("out") == test.Bytes("whole"));
}

TEST_CASE("without --resume a batch starts anew") {
  CrateBatch test(kBoxSpec);
  const Request request = test.Of(3000, "out");
  REQUIRE(MakeUpTo(test, request, 500).interrupted);
  const Summary summary = test.Make(request);
  CHECK(summary.kept == 0);
  CHECK(summary.ok == 3000);
  CHECK_FALSE(output::PartFile::Exists(test.folder / "out/manifest.jsonl"));
}

TEST_CASE("a batch of other options is not gone on with") {
  CrateBatch test(kBoxSpec);
  for (const std::string output : {"out", "tar/x.tar"}) {
    test.Make(test.Of(30, output));
    const auto before = test.Bytes(output.substr(0, 3));
    Request request = Resuming(test.Of(30, output));
    request.variant.seed = 2;
    const Summary summary = test.Make(request);
    CHECK(summary.output_failed);
    REQUIRE(summary.findings.size() == 1);
    CHECK(summary.findings[0].code == diag::Code::kBatchDiffers);
    CHECK(summary.findings[0].message.ends_with("belongs to another batch: seed is '1', not '2'"));
    CHECK(test.Bytes(output.substr(0, 3)) == before);
  }
}

TEST_CASE("a line that a crash cut short is made again") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(30, "out"));
  const auto whole = test.Bytes("out");
  const std::string manifest = test.folder.Read("out/manifest.jsonl");
  std::filesystem::remove(test.folder / "out/manifest.jsonl");
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, manifest.find('\n'),
                                 manifest.find('\n') + 1, manifest.size() - 1, manifest.size()}) {
    test.folder.Write("out/.manifest.jsonl.part", manifest.substr(0, size));
    CHECK(test.Make(Resuming(test.Of(30, "out"))).ok == 30);
    CHECK(test.Bytes("out") == whole);
    std::filesystem::remove(test.folder / "out/manifest.jsonl");
  }
}

TEST_CASE("a variant whose worker died is tried again") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(30, "out"));
  const auto whole = test.Bytes("out");
  std::string manifest = test.folder.Read("out/manifest.jsonl");
  std::size_t line = 0;
  for (int i = 0; i < 7; ++i) line = manifest.find('\n', line) + 1;
  std::string why_not;
  auto record = manifest::ReadRecord(
      std::string_view(manifest).substr(line, manifest.find('\n', line) - line), why_not);
  REQUIRE(record);
  record->status = Status::kFailed;
  record->nbody = 0;
  record->file.clear();
  record->sha256.clear();
  record->findings = {R"({"severity":"error","code":"batch/worker-died","message":"x"})"};
  CHECK(FailedByChance(*record));
  std::string failed;
  manifest::AppendRecord(failed, *record);
  manifest.replace(line, manifest.find('\n', line) + 1 - line, failed);
  test.folder.Write("out/manifest.jsonl", manifest);
  std::filesystem::remove(test.folder / "out/crate_000007.xml");
  const Summary summary = test.Make(Resuming(test.Of(30, "out")));
  CHECK(summary.kept == 7);
  CHECK(test.Bytes("out") == whole);
}

TEST_CASE("two runs do not write one batch at the same time") {
  CrateBatch test(kBoxSpec);
  std::filesystem::create_directory(test.folder / "out");
  diag::Findings findings;
  const auto other = output::PartFile::Open(test.folder / "out/manifest.jsonl", findings);
  REQUIRE(other);
  const Summary summary = test.Make(test.Of(3, "out"));
  CHECK(summary.output_failed);
  REQUIRE(summary.findings.size() == 1);
  CHECK(summary.findings[0].message.ends_with("another mjforge is writing it"));
}

}  // namespace
}  // namespace mjforge::batch
