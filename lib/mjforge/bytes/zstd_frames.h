// Text files that consist of independent Zstandard frames, with a seek table at the end.
//
// The seek table has the seekable format of Zstandard's authors (contrib/seekable_format): a
// skippable frame, which other readers ignore.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct ZSTD_CCtx_s;

namespace mjforge::bytes {

class File;

/// Compresses texts, each into one frame with a checksum. A frame depends only on its text.
class FrameCompressor {
 public:
  FrameCompressor();
  ~FrameCompressor();
  FrameCompressor(const FrameCompressor&) = delete;
  FrameCompressor& operator=(const FrameCompressor&) = delete;

  /// Returns the frame, valid until the next call; no bytes if the text is empty.
  std::string_view Compress(std::string_view text);

 private:
  ZSTD_CCtx_s* context_;
  std::string frame_;
};

/// Position and sizes of a Zstandard frame in a file, in bytes.
struct Frame {
  std::uint64_t begin = 0;
  std::uint32_t bytes = 0;
  std::uint32_t text_bytes = 0;  // size when decompressed; 0 if not stored in the frame

  std::uint64_t end() const { return begin + bytes; }
};

/// Returns true if the file begins with a Zstandard frame (a skippable frame included); nullopt,
/// and sets `why_not`, if the file cannot be read.
std::optional<bool> IsCompressed(File& file, std::string& why_not);

/// Returns the frames of a compressed file from its seek table. If the file has no valid table,
/// reads the whole file. Reading leaves out skippable frames, and stops before a frame that is
/// damaged, incomplete or longer than kMaxFrame bytes. Returns nullopt, and sets `why_not`, if the
/// file cannot be read.
std::optional<std::vector<Frame>> FramesOf(const std::filesystem::path& file, std::string& why_not);
inline constexpr std::uint64_t kMaxFrame = std::uint64_t{64} << 20;

/// Returns the seek table of a file that consists of these frames.
std::string SeekTableOf(std::span<const Frame> frames);

}  // namespace mjforge::bytes
