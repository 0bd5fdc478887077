// Tests of Zstandard's frames and seek tables.

#include "mjforge/bytes/zstd_frames.h"

#include <catch2/catch.hpp>

#include "harness/command.h"
#include "harness/temporary_folder.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

struct FrameTest {
  // Returns the frames of a file with this content.
  std::vector<Frame> Find(std::string_view content) {
    const auto frames = FramesOf(folder.Write("x.zst", content), why_not);
    CHECK(why_not.empty());
    REQUIRE(frames);
    return *frames;
  }

  harness::TemporaryFolder folder;
  FrameCompressor compressor;
  std::string first{compressor.Compress("one\n")};
  std::string second{compressor.Compress(std::string(100'000, 'x') + "\n")};
  std::string why_not;
};

TEST_CASE_METHOD(FrameTest, "a frame depends only on its text") {
  CHECK(compressor.Compress("one\n") == first);
  CHECK(FrameCompressor().Compress("one\n") == first);
  CHECK(compressor.Compress("").empty());
}

TEST_CASE_METHOD(FrameTest, "frames are found with a seek table and without") {
  const std::string content = first + second;
  const std::vector<Frame> frames = Find(content);
  REQUIRE(frames.size() == 2);
  CHECK(frames[0].text_bytes == 4);
  CHECK(frames[1].begin == first.size());
  CHECK(frames[1].end() == content.size());
  CHECK(frames[1].text_bytes == 100'001);
  const std::vector<Frame> listed = Find(content + SeekTableOf(frames));
  REQUIRE(listed.size() == 2);
  CHECK(listed[1].begin == frames[1].begin);
  CHECK(listed[1].end() == frames[1].end());
  CHECK(listed[1].text_bytes == frames[1].text_bytes);
}

TEST_CASE("a seek table has the bytes of Zstandard's seekable format") {
  using namespace std::string_literals;
  const std::vector<Frame> frames = {{0, 0x01020304, 5}, {0x01020304, 6, 7}};
  CHECK(SeekTableOf(frames) ==
        "\x5e\x2a\x4d\x18\x19\0\0\0"s
        "\x04\x03\x02\x01\x05\0\0\0\x06\0\0\0\x07\0\0\0"
        "\x02\0\0\0\0\xb1\xea\x92\x8f"s);
}

TEST_CASE_METHOD(FrameTest, "a seek table that does not fit its file is not believed") {
  const std::string content = first + second;
  std::string table = SeekTableOf(Find(content));
  for (const std::size_t at : {0, 4, 8, 16, 24, 28}) {
    std::string changed = table;
    changed[at] ^= 1;
    INFO(at);
    const std::vector<Frame> frames = Find(content + changed);
    REQUIRE(frames.size() >= 2);
    CHECK(frames[1].begin == first.size());
  }
  CHECK(Find(SeekTableOf({})).empty());
  CHECK(Find(table.substr(1)).empty());
}

TEST_CASE_METHOD(FrameTest, "a file that was cut off has its whole frames") {
  const std::string content = first + second;
  for (std::size_t size = first.size(); size < content.size(); size += 3)
    CHECK(Find(content.substr(0, size)).size() == 1);
}

TEST_CASE_METHOD(FrameTest, "zstd decompresses the frames and ignores the table") {
  const auto file = folder.Write("x.zst", first + second + SeekTableOf(Find(first + second)));
  const harness::CommandResult result =
      harness::Command{.program = "zstd", .arguments = {"-dc", file.string()}}.Run();
  CHECK(result.status == 0);
  CHECK(result.out == "one\n" + std::string(100'000, 'x') + "\n");
}

TEST_CASE("a file that cannot be read has no frames") {
  std::string why_not;
  CHECK_FALSE(FramesOf("none.zst", why_not));
  CHECK(why_not == "No such file or directory");
  CHECK_FALSE(CutsOf("none.zst", why_not));
}

}  // namespace
}  // namespace mjforge::bytes
