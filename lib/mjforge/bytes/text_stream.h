// The text of a file as a stream of bytes, decompressed if the file consists of Zstandard frames.

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <zstd.h>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {

/// The text of a file from the start of a section (a range of the file's offsets) to the end of the
/// file.
class TextStream {
 public:
  TextStream(File file, bool is_compressed, const FileSection& section);

  /// Reads at least one byte, unless the text ends, and never across the end of the section.
  /// Returns the number of bytes read; nullopt, and sets `why_not`, if reading fails.
  std::optional<std::size_t> Read(std::span<char> buffer, std::string& why_not);
  /// Returns the number of bytes, of those read so far, that are behind the end of the section.
  std::uint64_t bytes_after_section() const { return bytes_after_section_; }
  /// Returns true if the file ends within a Zstandard frame.
  bool ends_in_frame() const { return is_at_end_ && is_in_frame_; }

 private:
  struct FreeDecoder {
    void operator()(ZSTD_DCtx* decoder) const { ZSTD_freeDCtx(decoder); }
  };

  std::optional<std::size_t> ReadStored(std::span<char> buffer, std::string& why_not);
  std::optional<std::size_t> Decompress(std::span<char> buffer, std::string& why_not);

  File file_;
  std::uint64_t position_;  // offset in the file of the next byte to read
  std::uint64_t end_;       // offset in the file of the end of the section
  std::uint64_t bytes_after_section_ = 0;
  bool is_after_section_ = false;  // true: the last bytes read are behind the end of the section
  bool is_at_end_ = false;
  std::unique_ptr<ZSTD_DCtx, FreeDecoder> decoder_;  // null: the file is not compressed
  std::string stored_;                     // bytes as stored in the file, before decompression
  ZSTD_inBuffer input_ = {nullptr, 0, 0};  // the bytes of `stored_` that are not decompressed yet
  bool has_output_ = false;  // true: the decoder has text that did not fit into the buffer
  bool is_in_frame_ = false;
};

}  // namespace mjforge::bytes
