// Tests of atomic writing.

#include "mjforge/output/atomic_file.h"

#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <thread>

#include "harness/effort.h"
#include "harness/temporary_folder.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

using harness::TemporaryFolder;

TEST_CASE("a name that is a folder cannot be taken") {
  const TemporaryFolder folder;
  folder.Write("x.xml/inside", "text");
  diag::Findings findings;
  CHECK_FALSE(WriteFile(folder / "x.xml", "new", false, findings, Durability::kBatch));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message ==
        "cannot write '" + (folder / "x.xml").string() + "': Is a directory");
  CHECK(folder.Files() == std::vector<std::string>{"x.xml/inside"});
}

TEST_CASE("a file that another process left under its first name is not disturbed") {
  const TemporaryFolder folder;
  const std::string left = ".x.tmp" + std::to_string(::getpid()) + "-0";
  folder.Write(left, "other");
  diag::Findings findings;
  REQUIRE(WriteFile(folder / "x", "text", false, findings, Durability::kBatch));
  CHECK(folder.Read("x") == "text");
  CHECK(folder.Read(left) == "other");
}

TEST_CASE("a file that is being written is not taken for one that was left") {
  const TemporaryFolder folder;
  std::atomic<bool> stop = false;
  std::thread other([&] {
    while (!stop) RemoveAbandoned({folder / "x"});
  });
  diag::Findings findings;
  for (int i = 0; i < harness::Effort(2000); ++i)
    WriteFile(folder / "x", std::to_string(i), false, findings);
  stop = true;
  other.join();
  CHECK(findings.empty());
  CHECK(folder.Files() == std::vector<std::string>{"x"});
}

TEST_CASE("a single file is written after what killed processes left of it is removed") {
  const TemporaryFolder folder;
  folder.Write(".x.html.tmp1-0", "other");
  folder.Write(".y.html.tmp1-0", "other");
  diag::Findings findings;
  REQUIRE(WriteSingleFile(folder / "x.html", "text", findings));
  CHECK(folder.Files() == std::vector<std::string>{".y.html.tmp1-0", "x.html"});
}

TEST_CASE("a temporary name contains the final one") {
  CHECK(FinalNameOf(".x.xml.tmp123-0") == "x.xml");
  for (const char* name : {"x.xml.tmp123-0", ".x.xml", ".x.xml.tmp123", ".x.xml.tmp-0", ".tmp1-0",
                           ".x.xml.tmp1-", ".x.xml.tmp1-2-3"}) {
    CHECK_FALSE(FinalNameOf(name));
  }
}

}  // namespace
}  // namespace mjforge::output
