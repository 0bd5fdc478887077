#pragma once

// Bytes of files, read within limits, and their hashes. Only regular files are read: a pipe may
// never end, and a device may hold anything. Standard input, which the user chose, is the
// exception.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mjforge::bytes {

/// The name of standard input.
inline constexpr const char* kStandardInput = "-";

/// More than any of these is not read: a file of MJCF; an asset (mesh, texture), where millions of
/// triangles fit and MuJoCo allows 200,000; all pictures of an object or a file of MJCF, of which
/// MuJoCo takes six bytes a pixel and more; a line of a manifest, of a journal. (YAML:
/// spec::kMaxYamlBytes.)
inline constexpr std::uint64_t kMaxMjcf = std::uint64_t{256} << 20;
inline constexpr std::uint64_t kMaxAsset = std::uint64_t{256} << 20;
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 26;  // 8192 x 8192
inline constexpr std::uint64_t kMaxLine = std::uint64_t{64} << 20;

/// An open file, read from its start on.
class File {
 public:
  /// Nothing, and why ("No such file or directory", "it is a pipe"), if it is not a regular file or
  /// cannot be opened.
  static std::optional<File> Open(const std::filesystem::path& file, std::string& why_not);

  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  ~File();

  /// Fills `buffer` unless the file ends before, and returns how many bytes were read; nothing, and
  /// why, if reading fails.
  std::optional<std::size_t> Read(std::span<char> buffer, std::string& why_not);

 private:
  explicit File(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

/// The content of a file or of standard input (the same each time); nothing, and why, if it cannot
/// be read or has more than `limit` bytes.
std::optional<std::string> Read(const std::filesystem::path& file, std::uint64_t limit,
                                std::string& why_not);
/// At most the first `limit` bytes.
std::optional<std::string> ReadStart(const std::filesystem::path& file, std::uint64_t limit,
                                     std::string& why_not);

/// What kind of file begins so ("a tar archive"); empty if it is text or not known.
std::string_view KindOf(std::string_view text);

/// Pixels of a PNG file, as its header has them; nothing for other files, and why if it cannot be
/// read.
std::optional<std::uint64_t> PngPixels(const std::filesystem::path& file, std::string& why_not);

/// A picture: rows from the top, red, green, blue and, with `has_alpha`, alpha (the colors are not
/// multiplied by it).
struct Pixels {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> colors;
  bool has_alpha = false;
};
/// Keywords and texts that a PNG file carries.
using PngTexts = std::vector<std::pair<std::string, std::string>>;
std::string EncodePng(const Pixels& pixels, const PngTexts& texts = {});

/// A file that a text refers to.
struct Asset {
  std::string name;                                   // in the text
  std::filesystem::path file;                         // where it is read from; empty: it is `made`
  std::shared_ptr<const std::string> made = nullptr;  // its content

  bool operator==(const Asset& other) const {
    return name == other.name && file == other.file &&
           (made == nullptr) == (other.made == nullptr) &&
           (made == nullptr || *made == *other.made);
  }
};
using Assets = std::vector<Asset>;

/// Whether it is a regular file (or standard input) of at most `limit` bytes; else why not.
bool MayRead(const std::filesystem::path& file, std::uint64_t limit, std::string& why_not);

/// Whether it is a regular file of this size; else why not ("it has 12 bytes, not 40").
bool HasSize(const std::filesystem::path& file, std::uint64_t size, std::string& why_not);

/// The lines of a file one after the other, in constant memory.
class LineReader {
 public:
  static std::optional<LineReader> Open(const std::filesystem::path& file, std::string& why_not);

  /// Replaces `line` with the next one, without its end. False at the end of the file, and where it
  /// cannot be read on: then `why_not` says why.
  bool Next(std::string& line, std::string& why_not);
  /// Whether the last line has no line end, because it was still being written.
  bool torn() const { return torn_; }

 private:
  explicit LineReader(File file);

  File file_;
  std::string buffer_;
  std::size_t begin_ = 0;  // of what is left in the buffer
  std::size_t end_ = 0;
  bool at_end_ = false;
  bool torn_ = false;
};

/// XXH3 with 128 bits of bytes that come piece by piece, as `xxh128sum` prints it: it finds what a
/// disk or a power cut does, at the speed of memory. It does not keep anyone from forging bytes.
class Checksum {
 public:
  Checksum();
  ~Checksum();
  Checksum(const Checksum&) = delete;
  Checksum& operator=(const Checksum&) = delete;

  void Add(std::string_view bytes);
  /// Adds the next `count` bytes of a file; false if it has fewer or cannot be read.
  bool Add(File& file, std::uint64_t count);
  /// Of all bytes so far, in hexadecimal.
  std::string Text() const;
  void Clear();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

std::string ChecksumOf(std::string_view bytes);

/// The first bytes of a file, and their checksum.
struct Prefix {
  std::uint64_t size = 0;
  std::string checksum;
};
/// How many of the prefixes, in ascending order of size, the file really begins with, before the
/// first that it does not. 0 if it cannot be read.
std::size_t CountSound(const std::filesystem::path& file, std::span<const Prefix> prefixes);

/// Whether the file has this size and this checksum; else why not ("it has 12 bytes, not 40").
bool IsSound(const std::filesystem::path& file, const Prefix& whole, std::string& why_not);

/// SHA-256, in hexadecimal.
std::string Sha256Of(std::string_view bytes);

}  // namespace mjforge::bytes
