// Tests of temporary folders.

#include "harness/temporary_folder.h"

#include <catch2/catch.hpp>

namespace mjforge::harness {

namespace fs = std::filesystem;

TEST_CASE("a temporary folder starts empty and lists what is written, sorted") {
  const TemporaryFolder folder;
  CHECK(folder.Files().empty());
  folder.Write("b/c.txt", "c");
  folder.Write("a.txt", "a");
  CHECK(folder.Files() == std::vector<std::string>{"a.txt", "b/c.txt"});
  CHECK(folder.Read("b/c.txt") == "c");
}

TEST_CASE("two temporary folders are not the same") {
  const TemporaryFolder one;
  const TemporaryFolder two;
  CHECK(one.path() != two.path());
}

TEST_CASE("a temporary folder goes, even with read-only folders in it") {
  fs::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    folder.Write("locked/file", "text");
    fs::permissions(folder / "locked", fs::perms::owner_read);
  }
  CHECK_FALSE(fs::exists(path));
}

}  // namespace mjforge::harness
