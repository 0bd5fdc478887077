#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

using harness::TemporaryFolder;
using Files = std::vector<std::string>;

Record RecordOf(std::uint64_t index) {
  Record record;
  record.name = "box";
  record.index = index;
  record.file = VariantFileName("box", index);
  record.spec = "primitives/box";
  record.spec_sha256 = std::string(64, 'a');
  record.status = "ok";
  record.target = "mujoco";
  record.sha256 = std::string(64, 'b');
  return record;
}

mjcf::MjcfDocument DocumentOf(const std::string& text) {
  mjcf::MjcfDocument document;
  document.text = text;
  return document;
}

// One whole batch of one variant.
bool WriteBatch(const std::filesystem::path& folder, bool force, diag::Findings& findings) {
  auto writer = DirectoryWriter::Open(folder, force, findings);
  return writer && writer->Write("box_000000.xml", DocumentOf("<mujoco/>\n"), findings) &&
         writer->Add(RecordOf(0), findings) && writer->Finish(findings);
}

TEST_CASE("a batch makes the folder, those above it, its files and a manifest") {
  const TemporaryFolder folder;
  diag::Findings findings;
  REQUIRE(WriteBatch(folder / "a/b/out", false, findings));
  CHECK(folder.Files() == Files{"a/b/out/box_000000.xml", "a/b/out/manifest.jsonl"});
  std::string line;
  AppendRecord(line, RecordOf(0));
  CHECK(folder.Read("a/b/out/manifest.jsonl") == line);
}

TEST_CASE("the manifest has its name only from Finish on") {
  const TemporaryFolder folder;
  diag::Findings findings;
  auto writer = DirectoryWriter::Open(folder / "out", false, findings);
  REQUIRE(writer);
  REQUIRE(writer->Add(RecordOf(0), findings));
  CHECK_FALSE(std::filesystem::exists(folder / "out/manifest.jsonl"));
  REQUIRE(writer->Finish(findings));
  CHECK(std::filesystem::exists(folder / "out/manifest.jsonl"));
}

TEST_CASE("a batch that wrote nothing takes the folders it made with it") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a");
  diag::Findings findings;
  {
    auto writer = DirectoryWriter::Open(folder / "a/b/out", false, findings);
    REQUIRE(writer);
    REQUIRE(std::filesystem::is_directory(folder / "a/b/out"));
  }
  CHECK(std::filesystem::is_directory(folder / "a"));
  CHECK_FALSE(std::filesystem::exists(folder / "a/b"));
}

TEST_CASE("an unfinished batch leaves its whole files and no manifest") {
  const TemporaryFolder folder;
  diag::Findings findings;
  {
    auto writer = DirectoryWriter::Open(folder / "out", false, findings);
    REQUIRE(writer);
    REQUIRE(writer->Write("box_000000.xml", DocumentOf("<mujoco/>\n"), findings));
  }
  CHECK(folder.Files() == Files{"out/box_000000.xml"});
}

TEST_CASE("a folder with a manifest of ours is written again") {
  const TemporaryFolder folder;
  diag::Findings findings;
  std::string line;
  AppendRecord(line, RecordOf(7));
  folder.Write("out/manifest.jsonl", line);
  CHECK(WriteBatch(folder / "out", false, findings));
  CHECK(findings.empty());
}

TEST_CASE("a folder with somebody else's manifest is refused without force") {
  const TemporaryFolder folder;
  diag::Findings findings;
  folder.Write("out/manifest.jsonl", "{\"image\": \"a.png\"}\n");
  CHECK_FALSE(WriteBatch(folder / "out", false, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputExists);
  CHECK(findings[0].message ==
        "'" + (folder / "out/manifest.jsonl").string() + "' exists and was not made by mjforge");
  CHECK(folder.Files() == Files{"out/manifest.jsonl"});
  diag::Findings none;
  CHECK(WriteBatch(folder / "out", true, none));
  CHECK(none.empty());
}

TEST_CASE("a foreign file with a variant's name is not overwritten without force") {
  const TemporaryFolder folder;
  diag::Findings findings;
  folder.Write("out/box_000000.xml", "mine");
  CHECK_FALSE(WriteBatch(folder / "out", false, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputExists);
  CHECK(folder.Read("out/box_000000.xml") == "mine");
  CHECK(folder.Files() == Files{"out/box_000000.xml"});
}

TEST_CASE("a folder whose name is a file's is a finding") {
  const TemporaryFolder folder;
  const auto file = folder.Write("out", "text");
  diag::Findings findings;
  CHECK_FALSE(DirectoryWriter::Open(file, false, findings).has_value());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputCannotWrite);
  CHECK(findings[0].message == "cannot make folder '" + file.string() + "': Not a directory");
}

TEST_CASE("assets are copied beside the objects, each once") {
  const TemporaryFolder folder;
  const auto wood = folder.Write("textures/wood.png", "pixels");
  mjcf::MjcfDocument document = DocumentOf("<mujoco/>\n");
  document.assets = {{"assets/wood.png", wood}};
  diag::Findings findings;
  auto writer = DirectoryWriter::Open(folder / "out", false, findings);
  REQUIRE(writer);
  REQUIRE(writer->Write("box_000000.xml", document, findings));
  std::filesystem::remove(wood);  // would be missed if it were read again
  REQUIRE(writer->Write("box_000001.xml", document, findings));
  CHECK(folder.Read("out/assets/wood.png") == "pixels");
}

TEST_CASE("an asset that is there with the same content is left alone") {
  const TemporaryFolder folder;
  const auto wood = folder.Write("wood.png", "pixels");
  const auto copy = folder.Write("out/assets/wood.png", "pixels");
  const auto time = std::filesystem::file_time_type(std::chrono::seconds(1));
  std::filesystem::last_write_time(copy, time);
  mjcf::MjcfDocument document;
  document.assets = {{"assets/wood.png", wood}};
  diag::Findings findings;
  CHECK(CopyAssets(document, folder / "out", false, findings));
  CHECK(std::filesystem::last_write_time(copy) == time);
}

TEST_CASE("an asset that is there with other content is replaced only with force") {
  const TemporaryFolder folder;
  const auto wood = folder.Write("wood.png", "pixels");
  const auto copy = folder.Write("out/assets/wood.png", "others");
  mjcf::MjcfDocument document;
  document.assets = {{"assets/wood.png", wood}};
  diag::Findings findings;
  CHECK_FALSE(CopyAssets(document, folder / "out", false, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message ==
        "'" + copy.string() + "' exists with other content than '" + wood.string() + "'");
  CHECK(folder.Read("out/assets/wood.png") == "others");
  CHECK(CopyAssets(document, folder / "out", true, findings));
  CHECK(folder.Read("out/assets/wood.png") == "pixels");
}

}  // namespace
}  // namespace mjforge::output
