// Tests of folders of objects and assets.

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/bytes/bytes.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

using harness::TemporaryFolder;
using Files = std::vector<std::string>;

mjcf::MjcfDocument DocumentOf(const std::string& text) {
  mjcf::MjcfDocument document;
  document.text = text;
  return document;
}

TEST_CASE("an object's folder is made, with those above it and those in its name") {
  const TemporaryFolder folder;
  diag::Findings findings;
  ObjectFolder objects(folder / "a/b/out", {});
  REQUIRE(objects.Write("box_000000.xml", DocumentOf("<mujoco/>\n"), findings));
  REQUIRE(objects.Write("0010000/box_010000.xml", DocumentOf("<mujoco/>\n"), findings));
  CHECK(folder.Files() == Files{"a/b/out/0010000/box_010000.xml", "a/b/out/box_000000.xml"});
}

TEST_CASE("folders that stay empty vanish") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a");
  diag::Findings findings;
  {
    MadeFolders folders;
    REQUIRE(folders.Make(folder / "a/b/out", findings));
    REQUIRE(folders.Make(folder / "a/c", findings));
    folder.Write("a/c/file", "text");
    REQUIRE(std::filesystem::is_directory(folder / "a/b/out"));
  }
  CHECK(std::filesystem::is_directory(folder / "a/c"));
  CHECK_FALSE(std::filesystem::exists(folder / "a/b"));
}

TEST_CASE("a foreign file with an object's name is not overwritten without force") {
  const TemporaryFolder folder;
  diag::Findings findings;
  folder.Write("out/box_000000.xml", "mine");
  ObjectFolder objects(folder / "out", {});
  CHECK_FALSE(objects.Write("box_000000.xml", DocumentOf("<mujoco/>\n"), findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputExists);
  CHECK(folder.Read("out/box_000000.xml") == "mine");
  ObjectFolder forced(folder / "out", {.force = true});
  CHECK(forced.Write("box_000000.xml", DocumentOf("<mujoco/>\n"), findings));
  CHECK(folder.Read("out/box_000000.xml") == "<mujoco/>\n");
}

TEST_CASE("a folder whose name is a file's is a finding") {
  const TemporaryFolder folder;
  const auto file = folder.Write("out", "text");
  diag::Findings findings;
  CHECK_FALSE(ObjectFolder(file, {}).Write("x.xml", DocumentOf("<mujoco/>\n"), findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kOutputCannotWrite);
  CHECK(findings[0].message == "cannot make folder '" + file.string() + "': Not a directory");
}

TEST_CASE("assets are copied beside each folder's objects, once each") {
  const TemporaryFolder folder;
  const auto wood = folder.Write("textures/wood.png", "pixels");
  mjcf::MjcfDocument document = DocumentOf("<mujoco/>\n");
  document.assets = {{"assets/wood.png", wood}};
  diag::Findings findings;
  ObjectFolder objects(folder / "out", {});
  REQUIRE(objects.Write("box_000000.xml", document, findings));
  REQUIRE(objects.Write("0010000/box_010000.xml", document, findings));
  std::filesystem::remove(wood);  // a second read of the file would fail
  REQUIRE(objects.Write("box_000001.xml", document, findings));
  CHECK(folder.Read("out/assets/wood.png") == "pixels");
  CHECK(folder.Read("out/0010000/assets/wood.png") == "pixels");
}

TEST_CASE("an asset that is there with the same content is left alone") {
  const TemporaryFolder folder;
  const auto wood = folder.Write("wood.png", "pixels");
  const auto copy = folder.Write("out/assets/wood.png", "pixels");
  const auto time = std::filesystem::file_time_type(std::chrono::seconds(1));
  std::filesystem::last_write_time(copy, time);
  mjcf::MjcfDocument document = DocumentOf("<mujoco/>\n");
  document.assets = {{"assets/wood.png", wood}};
  diag::Findings findings;
  CHECK(ObjectFolder(folder / "out", {}).Write("x.xml", document, findings));
  CHECK(std::filesystem::last_write_time(copy) == time);
}

TEST_CASE("an asset that is there with other content is replaced only where that is allowed") {
  const TemporaryFolder folder;
  const auto wood = folder.Write("wood.png", "pixels");
  const auto copy = folder.Write("out/assets/wood.png", "others");
  mjcf::MjcfDocument document = DocumentOf("<mujoco/>\n");
  document.assets = {{"assets/wood.png", wood}};
  diag::Findings findings;
  CHECK_FALSE(ObjectFolder(folder / "out", {}).Write("x.xml", document, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message ==
        "'" + copy.string() + "' exists, and its content differs from '" + wood.string() + "'");
  CHECK(folder.Files() == Files{"out/assets/wood.png", "wood.png"});
  CHECK(folder.Read("out/assets/wood.png") == "others");
  CHECK(ObjectFolder(folder / "out", {.assets = {bytes::Sha256Of("others")}})
            .Write("x.xml", document, findings));
  CHECK(folder.Read("out/assets/wood.png") == "pixels");
  // A damaged asset is restored; one that is kept is not replaced.
  folder.Write("out/assets/wood.png", "damaged");
  const std::string hash = bytes::Sha256Of("pixels");
  const AssetHashes hashes = {{"assets/wood.png", hash}};
  ObjectFolder kept(folder / "out", {.assets = {hash}, .kept_assets = {{"assets/wood.png", "0"}}});
  CHECK_FALSE(kept.Write("x.xml", document, findings, hashes));
  ObjectFolder restored(folder / "out", {.kept_assets = {{"assets/wood.png", hash}}});
  CHECK(restored.Write("x.xml", document, findings, hashes));
  CHECK(folder.Read("out/assets/wood.png") == "pixels");
}

// Returns the text of the file of an object of a scene (--each).
std::string PartText(const std::string& part, int index = 0) {
  return "<!-- mjforge 0.1.0 spec=a.yaml sha256=" + std::string(64, '0') +
         " seed=0 index=" + std::to_string(index) + " part=" + part +
         " target=robosuite -->\n<mujoco/>\n";
}

// Returns a placement with these files of objects.
mjcf::MjcfDocument PlacementOf(const Files& files) {
  mjcf::MjcfDocument document = DocumentOf("{\"mjforge\":\"0.1.0\"}\n");
  for (const std::string& file : files) {
    document.assets.push_back(
        {.name = file, .file = {}, .made = std::make_shared<const std::string>(PartText("x"))});
  }
  return document;
}

TEST_CASE("objects that a scene no longer has are removed from its folder, and nothing else") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const std::string at = "out/tea_000000/";
  for (const char* name : {"cup_0.xml", "cup_1.xml", "cup_0/model.xml"})
    folder.Write(at + name, PartText("cup"));
  folder.Write(at + "cup_1/model.xml", PartText("cup"));
  folder.Write(at + "cup_1/notes.txt", "mine");
  folder.Write(at + "mine.xml", "<mujoco/>");
  folder.Write(at + "other.xml", PartText("cup", 1));  // of another variant
  folder.Write(at + "deep/er/cup_2.xml", PartText("cup"));
  folder.Write("elsewhere/cup_3.xml", PartText("cup"));
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / at / "link");
  std::filesystem::create_symlink(folder / "elsewhere/cup_3.xml", folder / at / "link.xml");
  ObjectFolder objects(folder / "out", {});
  REQUIRE(objects.Write("tea_000000/placement.json", PlacementOf({"cup_0.xml"}), findings));
  CHECK_FALSE(std::filesystem::exists(folder / at / "cup_0"));
  CHECK(std::filesystem::is_symlink(folder / at / "link.xml"));
  std::filesystem::remove(folder / at / "link.xml");
  std::filesystem::remove(folder / at / "link");
  CHECK(folder.Files() == Files{"elsewhere/cup_3.xml", at + "cup_0.xml", at + "cup_1/notes.txt",
                                at + "deep/er/cup_2.xml", at + "mine.xml", at + "other.xml",
                                at + "placement.json"});
}

TEST_CASE("the files of a scene's objects are replaced like those of other objects") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "out/tea_000000");
  const std::filesystem::path cup = folder / "out/tea_000000/cup.xml";
  const auto message = [&](bool force) {
    diag::Findings findings;
    ObjectFolder objects(folder / "out", {.force = force});
    if (objects.Write("tea_000000/placement.json", PlacementOf({"cup.xml"}), findings))
      return std::string("written");
    REQUIRE(findings.size() == 1);
    return findings[0].message;
  };
  std::filesystem::create_symlink("nowhere", cup);
  CHECK(message(false) == "'" + cup.string() + "' is a link, not a file");
  CHECK(std::filesystem::is_symlink(cup));
  CHECK(message(true) == "written");
  CHECK(message(false) == "written");
  std::filesystem::remove(cup);
  std::filesystem::create_directory(cup);
  CHECK(message(false) == "'" + cup.string() + "' is a folder, not a file");
  CHECK(message(true) == "'" + cup.string() + "' is a folder, not a file");
  std::filesystem::remove(cup);
  REQUIRE(::mkfifo(cup.c_str(), 0600) == 0);
  CHECK(message(true) == "'" + cup.string() + "' is a pipe or a device, not a file");
}

TEST_CASE("what a killed process left half-written is removed, and nothing else") {
  const TemporaryFolder folder;
  const Files kept = {"out/.hammer_010042.xml.tmp7",
                      "out/.hammer_010043.xml.tmp7-0",
                      "out/.manifest.jsonl.part",
                      "out/.notes.txt.tmp7-0",
                      "out/0020000/assets/.wood.png.tmp7-0",
                      "out/hammer_010042.xml",
                      "out/hammer_010042.xml.tmp7-0",
                      "out/mine/.hammer_010042.xml.tmp7-0"};
  for (const std::string& file : kept) folder.Write(file, "");
  for (const char* objects :
       {"out/", "out/0010000/", "out/0123456789ab/", "out/0123456789ab/0010000/"}) {
    folder.Write(objects + std::string(".hammer_010042.xml.tmp7-0"), "");
    folder.Write(objects + std::string("assets/.wood.png.tmp123-99"), "");
  }
  const int living = ::open(folder.Write("out/.hammer_010042.xml.tmp8-0", "x").c_str(), O_RDONLY);
  REQUIRE(::flock(living, LOCK_EX | LOCK_NB) == 0);
  RemoveAbandoned(folder / "out", 10'042, 1);
  Files expected = kept;
  expected.push_back("out/.hammer_010042.xml.tmp8-0");
  std::ranges::sort(expected);
  CHECK(folder.Files() == expected);
  ::close(living);
  RemoveAbandoned({folder / "out/hammer_010042.xml", folder / "out/notes.txt"});
  CHECK(folder.Files().size() == kept.size() - 1);
  RemoveAbandoned(folder / "none", 0, 100);
}

TEST_CASE("what a killed process left behind a link is not removed") {
  const TemporaryFolder folder;
  folder.Write("elsewhere/.wood_000001.xml.tmp7-0", "");
  std::filesystem::create_directories(folder / "out");
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "out/0010000");
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "out/assets");
  RemoveAbandoned(folder / "out", 0, 20'000);
  CHECK(std::filesystem::exists(folder / "elsewhere/.wood_000001.xml.tmp7-0"));
}

TEST_CASE("a link in the place of a folder of objects or assets is not followed") {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "elsewhere");
  std::filesystem::create_directories(folder / "out");
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "out/0010000");
  std::filesystem::create_directory_symlink(folder / "elsewhere", folder / "out/assets");
  std::filesystem::create_directory_symlink(folder / "out", folder / "link");
  mjcf::MjcfDocument document = DocumentOf("<mujoco/>\n");
  diag::Findings findings;
  CHECK_FALSE(ObjectFolder(folder / "out", {}).Write("0010000/x_010000.xml", document, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message ==
        "'" + (folder / "out/0010000").string() + "' is a link, which is not followed");
  // The folder that the user named may be a link.
  CHECK(ObjectFolder(folder / "link", {}).Write("x_000000.xml", document, findings));
  document.assets = {{"assets/wood.png", folder.Write("wood.png", "pixels")}};
  CHECK_FALSE(ObjectFolder(folder / "out", {}).Write("x_000001.xml", document, findings));
  CHECK(std::filesystem::is_empty(folder / "elsewhere"));
}

}  // namespace
}  // namespace mjforge::output
