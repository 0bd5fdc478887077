// Tests of resuming batches: interrupted, damaged, finished and enlarged ones.

#include "mjforge/batch/sink.h"

#include <catch2/catch.hpp>

#include "crate_batch.h"
#include "harness/effort.h"

namespace mjforge::batch {
namespace {

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
  const auto third = static_cast<std::uint64_t>(harness::Effort(1000, 300));
  const std::uint64_t count = 3 * third;
  const std::uint64_t per_archive = 7 * third / 10;  // the last one has fewer
  test.Make(test.Of(count, std::string("whole") + output, per_archive));
  const Request request = test.Of(count, std::string("broken") + output, per_archive);
  const Summary first = test.MakeUpTo(request, third);
  REQUIRE(first.interrupted);
  REQUIRE(first.done() < count);
  CHECK(test.Bytes("broken") != test.Bytes("whole"));
  const Summary second = test.MakeUpTo(Resuming(request), 2 * third);
  CHECK(second.resumed > 0);
  std::uint64_t resumed = 0;
  Observer observer;
  observer.resumed = [&](std::uint64_t made) { resumed = made; };
  const Summary last = test.Make(Resuming(request), observer);
  CHECK(last.resumed >= second.resumed);
  CHECK(resumed == last.resumed);
  CHECK(last.done() == count);
  CHECK(test.Bytes("broken") == test.Bytes("whole"));
  // Run once more, with nothing left to do.
  const Summary again = test.Make(Resuming(request));
  CHECK(again.resumed == count);
  CHECK(test.Bytes("broken") == test.Bytes("whole"));
}

TEST_CASE("files that are gone or were changed are made again") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(100, "out"));
  const auto whole = test.Bytes("out");
  std::filesystem::remove(test.folder / "out/crate_000020.xml");
  test.folder.Write("out/crate_000050.xml", test.folder.Read("out/crate_000051.xml"));
  const Summary summary = test.Make(Resuming(test.Of(100, "out")));
  CHECK(summary.resumed == 20);
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
  CHECK(summary.resumed == 50);
  test.Make(test.Of(80, "whole"));
  CHECK(test.Bytes("out") == test.Bytes("whole"));
}

TEST_CASE("without --resume a batch starts anew") {
  CrateBatch test(kBoxSpec);
  const Request request = test.Of(3000, "out");
  REQUIRE(test.MakeUpTo(request, 500).interrupted);
  const Summary summary = test.Make(request);
  CHECK(summary.resumed == 0);
  CHECK(summary.ok == 3000);
  CHECK_FALSE(output::PartFile::Exists(test.folder / "out/manifest.jsonl"));
}

TEST_CASE("a seal without content is replaced, and another file in its place is not") {
  CrateBatch test(kBoxSpec);
  const Request request = Resuming(test.Of(30, "out"));
  test.Make(request);
  const auto whole = test.Bytes("out");
  const std::string seal = "out/manifest.seal.json";
  for (const char* text : {"", "{}", "null\n", "[]", "{ \n}"}) {
    INFO(text);
    test.folder.Write(seal, text);
    CHECK(test.Make(request).ok == 30);
    CHECK(test.Bytes("out") == whole);
  }
  for (const char* text : {"{\"a\": 1}", "0", "mine"}) {
    INFO(text);
    test.folder.Write(seal, text);
    CHECK(test.Make(request).files_failed);
    CHECK(test.folder.Read(seal) == text);
  }
}

TEST_CASE("objects of a batch that lost its seal are not written again") {
  CrateBatch test(kBoxSpec);
  const Request request = test.Of(30, "out");
  test.Make(request);
  const auto whole = test.Bytes("out");
  const auto kept = test.folder / "out/crate_000005.xml";
  const auto time = std::filesystem::last_write_time(kept) - std::chrono::hours(1);
  std::filesystem::last_write_time(kept, time);
  test.folder.Write("out/crate_000006.xml", "");
  std::filesystem::remove(test.folder / "out/manifest.seal.json");
  CHECK(test.Make(Resuming(test.Of(20, "out"))).files_failed);
  CHECK(test.Make(Resuming(request)).ok == 30);
  CHECK(test.Bytes("out") == whole);
  CHECK(std::filesystem::last_write_time(kept) == time);
}

TEST_CASE("a batch of other options, or with more variants, is not gone on with") {
  const bool is_done = GENERATE(false, true);
  CrateBatch test(kBoxSpec);
  for (const std::string output : {"out", "tar/x.tar"}) {
    const Request request = test.Of(500, output);
    const std::uint64_t made = (is_done ? test.Make(request) : test.MakeUpTo(request, 300)).done();
    const auto before = test.Bytes(output.substr(0, 3));
    for (const std::string difference : {"seed is '1', not '2'", "it has more than 40 variants"}) {
      Request other = Resuming(test.Of(difference[0] == 's' ? 500 : 40, output));
      if (difference[0] == 's') other.variant.seed = 2;
      const Summary summary = test.Make(other);
      CHECK(summary.files_failed);
      REQUIRE(summary.findings.size() == 1);
      CHECK(summary.findings[0].code == diag::Code::kBatchDiffers);
      CHECK(summary.findings[0].message.ends_with(difference));
      CHECK(test.Bytes(output.substr(0, 3)) == before);
    }
    CHECK(test.Make(Resuming(test.Of(made, output))).ok == made);
  }
}

TEST_CASE("what is under construction was damaged: the same bytes, or an honest error") {
  const std::string output = GENERATE("", "/x.tar", "/x.tar.zst", "/x_%05d.tar");
  INFO(output);
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(500, "whole" + output, 130));
  const auto whole = test.Bytes("whole");
  const Request request = test.Of(500, "broken" + output, 130);
  REQUIRE(test.MakeUpTo(request, 300).interrupted);
  const auto broken = test.Bytes("broken");
  std::uint32_t random = 1;
  for (const auto& [name, bytes] : broken) {
    if (name.find(".part") == name.npos && !name.ends_with(".tar")) continue;
    INFO(name);
    for (int damage = 0; damage < std::max(4, harness::Effort(8)); ++damage) {
      std::filesystem::remove_all(test.folder / "broken");
      for (const auto& [other, same] : broken) test.folder.Write("broken/" + other, same);
      random = random * 1664525 + 1013904223;
      const std::size_t at = bytes.empty() ? 0 : random % bytes.size();
      std::string changed = bytes;
      if (damage % 4 == 0) changed.resize(at);
      if (damage % 4 == 1 && !changed.empty()) changed[at] = static_cast<char>(changed[at] ^ 4);
      if (damage % 4 == 2)
        std::fill(changed.begin() + static_cast<std::ptrdiff_t>(at), changed.end(), '\0');
      if (damage % 4 == 3) changed.insert(at, "x");
      test.folder.Write("broken/" + name, changed);
      Request resuming = Resuming(request);
      resuming.verify = true;
      const Summary summary = test.Make(resuming);
      if (summary.files_failed) continue;
      CHECK(summary.done() == 500);
      CHECK(test.Bytes("broken") == whole);
    }
  }
}

TEST_CASE("what is done and was damaged is made again") {
  const std::string output = GENERATE("", "/x.tar", "/x.tar.zst", "/x_%05d.tar.zst");
  const bool resumes = GENERATE(false, true);
  INFO(output << ", resumes: " << resumes);
  CrateBatch test(kWoodenSpec);
  test.folder.Write("wood.png", Png('a'));
  Request request = test.Of(100, "out" + output, 40);
  test.Make(request);
  const auto whole = test.Bytes("out");
  request.resume = resumes;
  request.verify = resumes;
  for (const auto& [name, bytes] : whole) {
    if (name.ends_with(".xml") && name != "crate_000070.xml") continue;
    INFO(name);
    std::vector<std::string> damages = {"", bytes.substr(0, bytes.size() / 2),
                                        std::string(bytes.size(), '\0'), bytes + '\n',
                                        bytes.substr(0, bytes.size() - 1) + " \n"};
    for (const std::size_t at : {std::size_t{2}, bytes.size() / 2, bytes.size() - 2}) {
      damages.push_back(bytes);
      damages.back()[at] ^= 1;
    }
    for (const std::string& damaged : damages) {
      std::filesystem::remove_all(test.folder / "out");
      for (const auto& [file, same] : whole) test.folder.Write("out/" + file, same);
      test.folder.Write("out/" + name, damaged);
      CHECK(test.Make(request).ok == 100);
      CHECK(test.Bytes("out") == whole);
    }
    std::filesystem::remove(test.folder / "out" / name);
    CHECK(test.Make(request).ok == 100);
    CHECK(test.Bytes("out") == whole);
  }
}

TEST_CASE("archives are recognized without their seal, and without their manifest") {
  CrateBatch test(kWoodenSpec);
  test.folder.Write("wood.png", Png('a'));
  const std::string output = GENERATE("/x.tar", "/x_%05d.tar.zst");
  Request request = test.Of(100, "out" + output, 40);
  request.resume = GENERATE(false, true);
  test.Make(request);
  const auto whole = test.Bytes("out");
  std::filesystem::remove(test.folder / "out/x.manifest.seal.json");
  std::filesystem::remove(test.folder / "out/x.manifest.jsonl");
  CHECK(test.Make(request).ok == 100);
  CHECK(test.Bytes("out") == whole);
  // Another archive is not replaced, because nothing says that it is ours.
  std::filesystem::remove(test.folder / "out/x.manifest.seal.json");
  const std::string archive = output == "/x.tar" ? "out/x.tar" : "out/x_00001.tar.zst";
  test.folder.Write(archive, "mine");
  CHECK(test.Make(request).files_failed);
  CHECK(test.folder.Read(archive) == "mine");
}

TEST_CASE("a batch of other options is not gone on with when its seal or journal is lost") {
  CrateBatch test(kBoxSpec);
  const bool is_done = GENERATE(false, true);
  const std::string output = GENERATE("out", "out/x_%d.tar");
  Request request = test.Of(500, output, 130);
  if (is_done) test.Make(request);
  if (!is_done) REQUIRE(test.MakeUpTo(request, 300).interrupted);
  for (const auto& [name, bytes] : test.Bytes("out")) {
    if (name.ends_with(".seal.json") || name.ends_with(".journal.part"))
      std::filesystem::remove(test.folder / "out" / name);
  }
  const auto before = test.Bytes("out");
  request.variant.seed = 2;
  const Summary refused = test.Make(Resuming(request));
  REQUIRE(refused.findings.size() == 1);
  CHECK(refused.findings[0].message.ends_with("belongs to another batch: seed is '1', not '2'"));
  CHECK(test.Bytes("out") == before);
  request.variant.seed = 1;
  CHECK(test.Make(Resuming(request)).ok == 500);
  test.Make(test.Of(500, "whole" + output.substr(3), 130));
  CHECK(test.Bytes("out") == test.Bytes("whole"));
}

TEST_CASE("a line of the journal with another blank is not trusted") {
  CrateBatch test(kBoxSpec);
  const Request request = test.Of(500, "out");
  REQUIRE(test.MakeUpTo(request, 300).interrupted);
  const std::string file = "out/.manifest.jsonl.journal.part";
  std::string journal = test.folder.Read(file);
  journal[journal.find('\n') - 17] = '\t';  // the blank before the checksum of the first line
  test.folder.Write(file, journal);
  const Summary summary = test.Make(Resuming(request));
  CHECK(summary.resumed == 0);
  CHECK(summary.ok == 500);
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
  CHECK(HasWorkerDied(*record));
  std::string failed;
  manifest::AppendRecord(failed, *record);
  manifest.replace(line, manifest.find('\n', line) + 1 - line, failed);
  test.folder.Write("out/manifest.jsonl", manifest);
  auto seal = manifest::ReadSeal(test.folder.Read("out/manifest.seal.json"), why_not);
  REQUIRE(seal);
  seal->manifest.content = {manifest.size(), bytes::ChecksumOf(manifest)};
  test.folder.Write("out/manifest.seal.json", manifest::SealText(*seal));
  std::filesystem::remove(test.folder / "out/crate_000007.xml");
  const Summary summary = test.Make(Resuming(test.Of(30, "out")));
  CHECK(summary.resumed == 7);
  CHECK(test.Bytes("out") == whole);
}

TEST_CASE("a series is not gone on with for another output") {
  CrateBatch test(kBoxSpec);
  const bool is_done = GENERATE(false, true);
  const Request request = test.Of(500, "out/x_%05d.tar", 130);
  if (is_done) test.Make(request);
  if (!is_done) REQUIRE(test.MakeUpTo(request, 300).interrupted);
  const auto before = test.Bytes("out");
  Request other = Resuming(test.Of(500, "out/x_%05d.tar", 131));
  const Summary per_archive = test.Make(other);
  REQUIRE(per_archive.findings.size() == 1);
  CHECK(per_archive.findings[0].message.ends_with(
      "belongs to another batch: per_archive is '130', not '131'"));
  other = Resuming(request);
  other.variant.name = "box";
  const Summary name = test.Make(other);
  REQUIRE(name.findings.size() == 1);
  CHECK(name.findings[0].message.ends_with("belongs to another batch: name is '', not 'box'"));
  CHECK(test.Bytes("out") == before);
}

TEST_CASE("an archive's manifest is not another archive's") {
  CrateBatch test(kBoxSpec);
  test.Make(test.Of(10, "x.tar"));
  const Summary refused = test.Make(test.Of(10, "x.tar.zst"));
  REQUIRE(refused.files_failed);
  CHECK(refused.findings[0].code == diag::Code::kOutputExists);
  CHECK(refused.findings[0].message.ends_with("x.manifest.jsonl' is the manifest of 'x.tar'"));
  CHECK_FALSE(std::filesystem::exists(test.folder / "x.tar.zst"));
}

TEST_CASE("what is not ours is not taken for a part of a batch") {
  const auto [output, part] =
      GENERATE(table<const char*, const char*>({{"out", "out/.manifest.jsonl.part"},
                                                {"out/x.tar", "out/.x.manifest.jsonl.part"},
                                                {"out/x.tar", "out/x.tar"}}));
  CrateBatch test(kBoxSpec);
  test.folder.Write(part, "mine");
  for (const bool resume : {false, true}) {
    Request request = test.Of(10, output);
    request.resume = resume;
    const Summary refused = test.Make(request);
    REQUIRE(refused.files_failed);
    CHECK(refused.findings[0].code == diag::Code::kOutputExists);
    CHECK(test.folder.Read(part) == "mine");
    CHECK_FALSE(std::filesystem::exists(test.folder / "out/.manifest.jsonl.journal.part"));
  }
}

TEST_CASE("a link in the place of a part is not followed") {
  const auto [output, part] =
      GENERATE(table<const char*, const char*>({{"out", "out/.manifest.jsonl.part"},
                                                {"out", "out/.manifest.jsonl.journal.part"},
                                                {"out/x.tar", "out/.x.tar.part"}}));
  CrateBatch test(kBoxSpec);
  test.folder.Write("elsewhere", "mine");
  std::filesystem::create_directory(test.folder / "out");
  std::filesystem::create_symlink(test.folder / "elsewhere", test.folder / part);
  Request request = test.Of(10, output);
  request.force = true;
  CHECK(test.Make(request).files_failed);
  CHECK(test.folder.Read("elsewhere") == "mine");
  if (std::string_view(part).find("journal") != std::string_view::npos)
    CHECK_FALSE(output::PartFile::Exists(test.folder / "out/manifest.jsonl"));
}

TEST_CASE("two runs do not write one batch at the same time") {
  CrateBatch test(kBoxSpec);
  std::filesystem::create_directory(test.folder / "out");
  diag::Findings findings;
  const auto other = output::PartFile::Open(test.folder / "out/manifest.jsonl", findings);
  REQUIRE(other);
  const Summary summary = test.Make(test.Of(3, "out"));
  CHECK(summary.files_failed);
  REQUIRE(summary.findings.size() == 1);
  CHECK(summary.findings[0].message.ends_with("another mjforge is writing it"));
}

}  // namespace
}  // namespace mjforge::batch
