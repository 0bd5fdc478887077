#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "harness/temporary_folder.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

TEST_CASE("a file is read whole, up to the limit") {
  const harness::TemporaryFolder folder;
  const std::string text(100'000, 'x');
  const auto file = folder.Write("x", text);
  std::string why_not;
  CHECK(Read(file, 100'000, why_not) == text);
  CHECK_FALSE(Read(file, 99'999, why_not));
  CHECK(why_not == "it has more than 99999 bytes");
  CHECK(ReadStart(file, 99'999, why_not) == text.substr(1));
  CHECK(ReadStart(file, 0, why_not) == "");
  CHECK(Read(folder.Write("empty", ""), 0, why_not) == "");
  CHECK(MayRead(file, 100'000, why_not));
  CHECK_FALSE(MayRead(file, 99'999, why_not));
}

TEST_CASE("only regular files are opened") {
  const harness::TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  std::filesystem::create_symlink("/dev/zero", folder / "zero");
  std::filesystem::create_symlink("loop", folder / "loop");
  const std::pair<std::filesystem::path, std::string> cases[] = {
      {pipe, "it is a pipe"},
      {folder / "zero", "it is a device"},
      {folder.path(), "it is a folder"},
      {folder / "none", "No such file or directory"},
      {folder / "loop", "Too many levels of symbolic links"}};
  for (const auto& [file, reason] : cases) {
    std::string why_not;
    CHECK_FALSE(Read(file, 10, why_not));
    CHECK(why_not == reason);
    CHECK_FALSE(LineReader::Open(file, why_not));
    CHECK(why_not == reason);
    CHECK_FALSE(MayRead(file, 10, why_not));
    CHECK(why_not == reason);
  }
}

}  // namespace
}  // namespace mjforge::bytes
