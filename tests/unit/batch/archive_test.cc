// Contents of archives, read by tar and zstd.

#include <catch2/catch.hpp>

#include "crate_batch.h"
#include "harness/command.h"

namespace mjforge::batch {
namespace {

// Returns the names of the members of an archive, listed by tar.
std::vector<std::string> Members(const std::filesystem::path& archive) {
  const harness::CommandResult result =
      harness::Command{.program = "tar", .arguments = {"-tf", archive.string()}}.Run();
  INFO(result.err);
  REQUIRE(result.status == 0);
  std::vector<std::string> names;
  std::string_view rest = result.out;
  while (!rest.empty()) {
    names.emplace_back(rest.substr(0, rest.find('\n')));
    rest.remove_prefix(names.back().size() + 1);
  }
  return names;
}

void Extract(const std::filesystem::path& archive, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  const harness::CommandResult result = harness::Command{
      .program = "tar",
      .arguments = {"-xf", archive.string(), "-C",
                    folder.string()}}.Run();
  INFO(result.err);
  REQUIRE(result.status == 0);
}

TEST_CASE("an archive has for each variant its object and its record") {
  CrateBatch test(kUnluckySpec);
  const auto ending = GENERATE(".tar", ".tar.zst");
  const Summary summary = test.Make(test.Of(200, std::string("x") + ending));
  REQUIRE(summary.failed > 0);
  Extract(test.folder / (std::string("x") + ending), test.folder / "got");
  CHECK(test.Bytes("got").size() == 2 * summary.ok);
  test.Make(test.Of(200, "files"));
  std::uint64_t compared = 0;
  for (const auto& [name, bytes] : test.Bytes("files")) {
    if (!name.ends_with(".xml")) continue;
    CHECK(test.folder.Read("got/" + name) == bytes);
    ++compared;
  }
  CHECK(compared == summary.ok);
  // The records are the manifest's lines, without the places of archive and spec.
  std::string manifest = test.ManifestText("x" + std::string(ending));
  const std::string archive = "\"archive\":\"x" + std::string(ending) + "\",";
  for (const std::string& place : {archive, std::string("\"spec_file\":\"crate.yaml\",")}) {
    for (std::size_t at = 0; (at = manifest.find(place, at)) != manifest.npos;)
      manifest.erase(at, place.size());
  }
  for (const auto& [name, bytes] : test.Bytes("got")) {
    if (name.ends_with(".json")) CHECK(manifest.find(bytes) != std::string::npos);
  }
}

TEST_CASE("an archive's bytes do not depend on its name") {
  CrateBatch test(kBoxSpec);
  const auto ending = GENERATE(".tar", ".tar.zst");
  for (const char* name : {"one", "deep/another"})
    test.Make(test.Of(100, std::string(name) + ending));
  CHECK(test.folder.Read(std::string("one") + ending) ==
        test.folder.Read(std::string("deep/another") + ending));
}

TEST_CASE("the bytes of archives do not depend on how many processes make them") {
  CrateBatch test(kUnluckySpec);
  for (const std::string output : {"x.tar", "x.tar.zst", "x_%05d.tar.zst"}) {
    for (const std::uint64_t jobs : {1, 2, 8}) {
      Request request = test.Of(1000, std::to_string(jobs) + "/" + output, 300);
      request.jobs = jobs;
      test.Make(request);
    }
    CHECK(test.Bytes("2") == test.Bytes("1"));
    CHECK(test.Bytes("8") == test.Bytes("1"));
  }
}

TEST_CASE("the manifest of a compressed archive is the plain one, compressed") {
  CrateBatch test(kUnluckySpec);
  test.Make(test.Of(300, "plain/x_%d.tar", 130));
  test.Make(test.Of(300, "packed/x_%d.tar.zst", 130));
  const auto zstd =
      harness::Command{.program = "zstd",
                       .arguments = {"-dc", (test.folder / "packed/x.manifest.jsonl.zst").string()}}
          .Run();
  REQUIRE(zstd.status == 0);
  CHECK(zstd.out == test.ManifestText("packed/x_%d.tar.zst"));
  std::string text = zstd.out;
  for (std::size_t at = 0; (at = text.find(".tar.zst", at)) != text.npos;) text.erase(at + 4, 4);
  CHECK(text == test.folder.Read("plain/x.manifest.jsonl"));
  // The seek table lists a frame for each segment of an archive.
  std::string why_not;
  const auto frames = bytes::FramesOf(test.folder / "packed/x.manifest.jsonl.zst", why_not);
  REQUIRE(frames);
  CHECK(frames->size() == 7);
  CHECK(test.folder.Read("packed/x.manifest.jsonl.zst").substr(frames->back().end()) ==
        bytes::SeekTableOf(*frames));
}

TEST_CASE("a series has so many variants in each archive, and says where each one is") {
  CrateBatch test(kBoxSpec);
  Request request = test.Of(25, "out/x-%03d.tar", 10);
  request.first = 7;
  test.Make(request);
  CHECK(test.folder.Files() ==
        std::vector<std::string>{"crate.yaml", "out/x-000.tar", "out/x-001.tar", "out/x-002.tar",
                                 "out/x.manifest.jsonl", "out/x.manifest.seal.json"});
  const auto members = Members(test.folder / "out/x-002.tar");
  REQUIRE(members.size() == 10);
  CHECK(members.front() == "crate_000027.xml");
  CHECK(members[1] == "crate_000027.json");
  CHECK(test.folder.Read("out/x.manifest.jsonl")
            .find(R"({"file":"crate_000027.xml","archive":"x-002.tar",)") != std::string::npos);
}

TEST_CASE("assets come once into each archive, before the first object that needs them") {
  CrateBatch test(kWoodenSpec);
  test.folder.Write("wood.png", Png('a'));
  test.Make(test.Of(150, "out/x_%d.tar", 100));
  for (const char* archive : {"out/x_0.tar", "out/x_1.tar"}) {
    const auto members = Members(test.folder / archive);
    REQUIRE_FALSE(members.empty());
    CHECK(members.front() == "assets/wood.png");
    CHECK(std::count(members.begin(), members.end(), "assets/wood.png") == 1);
  }
  Extract(test.folder / "out/x_1.tar", test.folder / "got");
  CHECK(test.folder.Read("got/assets/wood.png") == Png('a'));
}

TEST_CASE("an archive that mjforge did not make is not replaced without force") {
  CrateBatch test(kBoxSpec);
  test.folder.Write("x.tar", "mine");
  Request request = test.Of(3, "x.tar");
  const Summary refused = test.Make(request);
  CHECK(refused.files_failed);
  CHECK(refused.findings[0].code == diag::Code::kOutputExists);
  CHECK(test.folder.Read("x.tar") == "mine");
  CHECK(test.folder.Files() == std::vector<std::string>{"crate.yaml", "x.tar"});
  request.force = true;
  CHECK(test.Make(request).ok == 3);
  request.force = false;
  CHECK(test.Make(request).ok == 3);  // an earlier run made this one
}

}  // namespace
}  // namespace mjforge::batch
