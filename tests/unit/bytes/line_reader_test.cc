// Tests of reading text files line by line, plain and compressed, in whole and in sections.

#include <catch2/catch.hpp>
#include <filesystem>
#include <numeric>

#include "harness/temporary_folder.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

struct AllLines {
  std::vector<std::string> lines;
  std::string why_not;
  bool is_truncated = false;
};

AllLines LinesOf(const std::filesystem::path& file, const FileSection& section = {}) {
  AllLines all;
  std::optional<LineReader> lines = LineReader::Open(file, all.why_not, section);
  REQUIRE(lines);
  std::string line;
  while (lines->Next(line, all.why_not)) all.lines.push_back(line);
  all.is_truncated = lines->is_truncated();
  return all;
}

TEST_CASE("lines are read one after the other") {
  const harness::TemporaryFolder folder;
  const std::string large(1'000'000, 'x');
  const AllLines all = LinesOf(folder.Write("x", "a\n\n" + large + "\nb\n"));
  CHECK(all.lines == std::vector<std::string>{"a", "", large, "b"});
  CHECK_FALSE(all.is_truncated);
  CHECK(LinesOf(folder.Write("empty", "")).lines.empty());
}

TEST_CASE("a line without an end is truncated") {
  const harness::TemporaryFolder folder;
  const AllLines all = LinesOf(folder.Write("x", "a\nb"));
  CHECK(all.lines == std::vector<std::string>{"a", "b"});
  CHECK(all.is_truncated);
}

TEST_CASE("a line that is too long ends the reading, in little memory") {
  const harness::TemporaryFolder folder;
  const auto file = folder.Write("x", "a\n");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // sparse
  const AllLines all = LinesOf(file);
  CHECK(all.lines == std::vector<std::string>{"a"});
  CHECK(all.why_not == "a line has more than 64 MiB");
}

// Returns the frames of texts, one after the other.
std::string Compressed(const std::vector<std::string>& texts) {
  FrameCompressor compressor;
  std::string frames;
  for (const std::string& text : texts) frames += compressor.Compress(text);
  return frames;
}

TEST_CASE("a compressed file has the lines of its text, wherever its frames end") {
  const harness::TemporaryFolder folder;
  const std::string large(1'000'000, 'x');
  const AllLines all = LinesOf(folder.Write("x", Compressed({"a\nb", "c\n", large + "\n\nd\n"})));
  CHECK(all.lines == std::vector<std::string>{"a", "bc", large, "", "d"});
  CHECK(all.why_not.empty());
  CHECK_FALSE(all.is_truncated);
}

TEST_CASE("a compressed file that was cut off ends with its last whole frame") {
  const harness::TemporaryFolder folder;
  const std::string first = Compressed({"a\n"});
  const AllLines all = LinesOf(folder.Write("x", first + first.substr(0, first.size() - 1)));
  CHECK(all.lines.front() == "a");
  CHECK(all.why_not == "its last frame is incomplete");
  CHECK(all.is_truncated);
}

TEST_CASE("a damaged frame is an error") {
  const harness::TemporaryFolder folder;
  std::string frames = Compressed({"abcdefgh\n"});
  frames[frames.size() - 6] ^= 1;
  const AllLines all = LinesOf(folder.Write("x", frames));
  CHECK(all.why_not.starts_with("it is damaged (Zstandard: "));
}

TEST_CASE("consecutive sections have each line once, wherever a file is divided") {
  const harness::TemporaryFolder folder;
  std::vector<std::string> expected;
  std::vector<std::string> texts;
  for (int i = 0; i < 60; ++i) {
    expected.push_back(std::string(static_cast<std::size_t>(i * 7 % 20), 'x') + std::to_string(i));
    // Every third frame ends within a line.
    if (i % 5 == 0) texts.emplace_back();
    texts.back() += expected.back().substr(0, 1);
    if (i % 15 == 4) texts.emplace_back();
    texts.back() += expected.back().substr(1) + "\n";
  }
  std::string text;
  for (const std::string& piece : texts) text += piece;
  const auto plain = folder.Write("plain", text);
  const auto compressed = folder.Write("compressed", Compressed(texts));
  std::string why_not;
  std::vector<std::uint64_t> bytes(text.size());
  std::iota(bytes.begin(), bytes.end(), 0);
  const auto frames = CutsOf(compressed, why_not);
  REQUIRE(frames);
  CHECK(frames->size() == texts.size());
  const auto check = [&](const std::filesystem::path& file,
                         const std::vector<std::uint64_t>& cuts) {
    for (const std::size_t step : {1, 2, 7}) {
      std::vector<std::string> lines;
      for (std::size_t i = 0; i < cuts.size(); i += step) {
        FileSection section{.begin = cuts[i]};
        if (i + step < cuts.size()) section.end = cuts[i + step];
        const AllLines all = LinesOf(file, section);
        CHECK(all.why_not.empty());
        lines.insert(lines.end(), all.lines.begin(), all.lines.end());
      }
      CHECK(lines == expected);
    }
  };
  check(plain, bytes);
  check(compressed, *frames);
}

}  // namespace
}  // namespace mjforge::bytes
