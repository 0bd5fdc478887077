#include "mjforge/output/atomic_file.h"

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"

namespace mjforge::output {
namespace {

using harness::TemporaryFolder;

TEST_CASE("a file has its name only from Commit on") {
  const TemporaryFolder folder;
  diag::Findings findings;
  auto file = AtomicFile::Create(folder / "x.xml", findings);
  REQUIRE(file);
  REQUIRE(file->Append("one ", findings));
  CHECK_FALSE(std::filesystem::exists(folder / "x.xml"));
  REQUIRE(file->Append("two", findings));
  REQUIRE(file->Commit(Durability::kBatch, findings));
  CHECK(folder.Read("x.xml") == "one two");
  CHECK(folder.Files() == std::vector<std::string>{"x.xml"});
}

TEST_CASE("a file without Commit leaves nothing, and what was there before stays") {
  const TemporaryFolder folder;
  folder.Write("x.xml", "old");
  diag::Findings findings;
  {
    auto file = AtomicFile::Create(folder / "x.xml", findings);
    REQUIRE(file);
    REQUIRE(file->Append("new", findings));
  }
  CHECK(folder.Read("x.xml") == "old");
  CHECK(folder.Files() == std::vector<std::string>{"x.xml"});
}

TEST_CASE("a name that is a folder cannot be taken") {
  const TemporaryFolder folder;
  folder.Write("x.xml/inside", "text");
  diag::Findings findings;
  auto file = AtomicFile::Create(folder / "x.xml", findings);
  REQUIRE(file);
  CHECK_FALSE(file->Commit(Durability::kBatch, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message ==
        "cannot write '" + (folder / "x.xml").string() + "': Is a directory");
  CHECK(folder.Files() == std::vector<std::string>{"x.xml/inside"});
}

TEST_CASE("two files under construction for one name do not disturb each other") {
  const TemporaryFolder folder;
  diag::Findings findings;
  auto first = AtomicFile::Create(folder / "x", findings);
  auto second = AtomicFile::Create(folder / "x", findings);
  REQUIRE((first && second));
  REQUIRE((first->Append("first", findings) && second->Append("second", findings)));
  REQUIRE(second->Commit(Durability::kBatch, findings));
  REQUIRE(first->Commit(Durability::kBatch, findings));
  CHECK(folder.Read("x") == "first");
  CHECK(folder.Files() == std::vector<std::string>{"x"});
}

}  // namespace
}  // namespace mjforge::output
