// Tests of files under construction.

#include "mjforge/output/part_file.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"

namespace mjforge::output {
namespace {

using harness::TemporaryFolder;
using Files = std::vector<std::string>;

TEST_CASE("a long file has its name only from Commit on") {
  const TemporaryFolder folder;
  diag::Findings findings;
  auto file = PartFile::Open(folder / "x.tar", findings);
  REQUIRE(file);
  REQUIRE(file->Append("one ", findings));
  CHECK(folder.Files() == Files{".x.tar.part"});
  CHECK(PartFile::Exists(folder / "x.tar"));
  REQUIRE(file->Append("two", findings));
  CHECK(file->size() == 7);
  REQUIRE(file->Commit(false, Durability::kBatch, findings));
  CHECK(folder.Read("x.tar") == "one two");
  CHECK(folder.Files() == Files{"x.tar"});
}

TEST_CASE("what a process left is gone on with, from any length") {
  const TemporaryFolder folder;
  diag::Findings findings;
  { REQUIRE(PartFile::Open(folder / "x", findings)->Append("one two", findings)); }
  auto file = PartFile::Open(folder / "x", findings);
  REQUIRE(file);
  CHECK(file->size() == 7);
  REQUIRE(file->Truncate(4, findings));
  REQUIRE(file->Append("three", findings));
  REQUIRE(file->Commit(false, Durability::kBatch, findings));
  CHECK(folder.Read("x") == "one three");
}

TEST_CASE("only one process at a time writes a file") {
  const TemporaryFolder folder;
  diag::Findings findings;
  auto first = PartFile::Open(folder / "x", findings);
  REQUIRE(first);
  CHECK_FALSE(PartFile::Open(folder / "x", findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message ==
        "cannot write '" + (folder / "x").string() + "': another mjforge is writing it");
  REQUIRE(first->Append("first", findings));
  REQUIRE(first->Commit(false, Durability::kBatch, findings));
  // The next part starts empty, and does not change the file with the final name.
  auto second = PartFile::Open(folder / "x", findings);
  REQUIRE(second);
  CHECK(second->size() == 0);
  second->Drop();
  CHECK(folder.Files() == Files{"x"});
  CHECK(folder.Read("x") == "first");
}

TEST_CASE("a long file leaves no part of the disk reserved") {
  const TemporaryFolder folder;
  diag::Findings findings;
  constexpr std::size_t kPiece = 200'000;
  constexpr std::size_t kSize = 100 * kPiece;
  const auto room = [&](const std::string& name) {
    struct stat status = {};
    REQUIRE(::stat((folder / name).c_str(), &status) == 0);
    return static_cast<std::size_t>(status.st_blocks) * 512;
  };
  {
    auto file = PartFile::Open(folder / "x", findings);
    for (int i = 0; i < 100; ++i) REQUIRE(file->Append(std::string(kPiece, 'x'), findings));
  }
  CHECK(room(".x.part") < kSize + kSize / 10);
  auto file = PartFile::Open(folder / "x", findings);
  REQUIRE(file->Append(std::string(kSize, 'y'), findings));
  REQUIRE(file->Commit(false, Durability::kBatch, findings));
  CHECK(room("x") < 2 * kSize + kSize / 10);
  const bool is_whole = folder.Read("x") == std::string(kSize, 'x') + std::string(kSize, 'y');
  CHECK(is_whole);
}

TEST_CASE("a long file with the same bytes keeps its time where that is asked for") {
  const TemporaryFolder folder;
  diag::Findings findings;
  const std::string bytes(200'000, 'x');
  const auto present = folder.Write("x", bytes);
  const auto old = std::filesystem::file_time_type(std::chrono::seconds(1));
  std::filesystem::last_write_time(present, old);
  auto file = PartFile::Open(present, findings);
  REQUIRE(file->Append(bytes, findings));
  REQUIRE(file->Commit(true, Durability::kBatch, findings));
  CHECK(std::filesystem::last_write_time(present) == old);
  auto other = PartFile::Open(present, findings);
  REQUIRE(other->Append(bytes.substr(1) + "y", findings));
  REQUIRE(other->Commit(true, Durability::kBatch, findings));
  CHECK(std::filesystem::last_write_time(present) != old);
  CHECK(folder.Files() == Files{"x"});
  CHECK(folder.Read("x").back() == 'y');
}

TEST_CASE("a long file in a folder that is not there is a finding") {
  const TemporaryFolder folder;
  diag::Findings findings;
  CHECK_FALSE(PartFile::Open(folder / "none/x", findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message ==
        "cannot write '" + (folder / "none/x").string() + "': No such file or directory");
}

TEST_CASE("a folder that is lost on the way is a finding") {
  const TemporaryFolder folder;
  folder.Write("out/old", "");
  diag::Findings findings;
  auto file = PartFile::Open(folder / "out/x", findings);
  REQUIRE(file);
  std::filesystem::remove_all(folder / "out");
  CHECK(file->Append("bytes", findings));  // the open file exists without a name
  CHECK_FALSE(file->Commit(false, Durability::kBatch, findings));
  CHECK(findings.size() == 1);
}

}  // namespace
}  // namespace mjforge::output
