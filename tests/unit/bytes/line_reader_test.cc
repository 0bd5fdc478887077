#include <catch2/catch.hpp>
#include <filesystem>

#include "harness/temporary_folder.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

struct AllLines {
  std::vector<std::string> lines;
  std::string why_not;
  bool torn = false;
};

AllLines LinesOf(const std::filesystem::path& file) {
  AllLines all;
  std::optional<LineReader> lines = LineReader::Open(file, all.why_not);
  REQUIRE(lines);
  std::string line;
  while (lines->Next(line, all.why_not)) all.lines.push_back(line);
  all.torn = lines->torn();
  return all;
}

TEST_CASE("lines are read one after the other") {
  const harness::TemporaryFolder folder;
  const std::string large(1'000'000, 'x');
  const AllLines all = LinesOf(folder.Write("x", "a\n\n" + large + "\nb\n"));
  CHECK(all.lines == std::vector<std::string>{"a", "", large, "b"});
  CHECK_FALSE(all.torn);
  CHECK(LinesOf(folder.Write("empty", "")).lines.empty());
}

TEST_CASE("a line without an end is torn") {
  const harness::TemporaryFolder folder;
  const AllLines all = LinesOf(folder.Write("x", "a\nb"));
  CHECK(all.lines == std::vector<std::string>{"a", "b"});
  CHECK(all.torn);
}

TEST_CASE("a line that is too long ends the reading, in little memory") {
  const harness::TemporaryFolder folder;
  const auto file = folder.Write("x", "a\n");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // sparse
  const AllLines all = LinesOf(file);
  CHECK(all.lines == std::vector<std::string>{"a"});
  CHECK(all.why_not == "a line has more than 64 MiB");
}

}  // namespace
}  // namespace mjforge::bytes
