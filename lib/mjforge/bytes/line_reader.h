// Reading of text files line by line, in whole or in sections.

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mjforge::bytes {

/// Section of a text file, between two offsets of CutsOf. Contains the lines that start after
/// `begin` and not after `end`, and the first line of the file if `begin` is 0, so that consecutive
/// sections contain each line once.
struct FileSection {
  std::uint64_t begin = 0;
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
};

/// Returns the offsets in a text file at which a section may begin, in ascending order from 0: the
/// starts of Zstandard frames or, if the file is not compressed, multiples of a constant. Returns
/// nullopt, and sets `why_not`, if the file cannot be read.
std::optional<std::vector<std::uint64_t>> CutsOf(const std::filesystem::path& file,
                                                 std::string& why_not);

class TextStream;

/// Reads a text file, or a section of it, line by line, in constant memory. Decompresses a file
/// that consists of Zstandard frames.
class LineReader {
 public:
  static std::optional<LineReader> Open(const std::filesystem::path& file, std::string& why_not,
                                        const FileSection& section = {});
  LineReader(LineReader&&) noexcept;
  ~LineReader();

  /// Replaces `line` with the next line, without its line end. Returns false at the end of the file
  /// and if reading fails; `why_not` is set only if reading fails.
  bool Next(std::string& line, std::string& why_not);
  /// Returns true if writing the file was interrupted: the last line has no line end, or the last
  /// Zstandard frame is incomplete.
  bool is_truncated() const { return is_truncated_; }

 private:
  LineReader(std::unique_ptr<TextStream> stream, bool skips_first);

  bool Fill(std::string& why_not);
  bool ReadLine(std::string& line, std::string& why_not);

  std::unique_ptr<TextStream> stream_;
  bool skips_first_;  // true: the first line belongs to the section before
  std::string buffer_;
  std::size_t begin_ = 0;  // the unread bytes of the buffer are [begin_, end_)
  std::size_t end_ = 0;
  bool at_end_ = false;
  bool is_truncated_ = false;
};

}  // namespace mjforge::bytes
