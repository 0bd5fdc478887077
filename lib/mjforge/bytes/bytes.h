// Reading of files within size limits, their checksums, and encoding of PNG.

#pragma once

// Only regular files are read, because a pipe may never end and a device may contain anything.
// Standard input is the exception, because the user chose it.

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

#include "mjforge/bytes/coder.h"
#include "mjforge/bytes/line_reader.h"
#include "mjforge/bytes/zstd_frames.h"

namespace mjforge::bytes {

/// File name that means standard input.
inline constexpr const char* kStandardInput = "-";

/// Size limits, in bytes, of an MJCF file, of an asset (mesh or texture), and of a line of a
/// manifest or a journal. An STL file of the largest size has five million triangles, far more than
/// the 200,000 that MuJoCo accepts. The limit for YAML is spec::kMaxYamlBytes.
inline constexpr std::uint64_t kMaxMjcf = std::uint64_t{256} << 20;
inline constexpr std::uint64_t kMaxAsset = std::uint64_t{256} << 20;
inline constexpr std::uint64_t kMaxLine = std::uint64_t{64} << 20;
/// Maximum number of pixels (8192 x 8192) of all texture files of an object or an MJCF file
/// together. MuJoCo needs at least six bytes of memory per pixel.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 26;

/// An open file that is read sequentially from its start.
class File {
 public:
  /// Returns nullopt, and sets `why_not` ("No such file or directory", "it is a pipe"), if `file`
  /// is not a regular file or cannot be opened.
  static std::optional<File> Open(const std::filesystem::path& file, std::string& why_not);

  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  ~File();

  /// Reads until `buffer` is full or the file ends. Returns the number of bytes read; nullopt, and
  /// sets `why_not`, if reading fails.
  std::optional<std::size_t> Read(std::span<char> buffer, std::string& why_not);
  /// Continues reading at this offset from the start of the file.
  void Seek(std::uint64_t offset);

 private:
  explicit File(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

/// Returns the content of a file or of standard input. Keeps the content of standard input, so that
/// several calls can return it. Returns nullopt, and sets `why_not`, if reading fails or the
/// content has more than `limit` bytes.
std::optional<std::string> Read(const std::filesystem::path& file, std::uint64_t limit,
                                std::string& why_not);
/// Returns the first `limit` bytes of a file or of standard input, or the whole content if it is
/// shorter. Returns nullopt, and sets `why_not`, if reading fails.
std::optional<std::string> ReadStart(const std::filesystem::path& file, std::uint64_t limit,
                                     std::string& why_not);

/// Returns the kind of binary file that begins with `text` ("a tar archive"); empty for text and
/// unknown formats.
std::string_view KindOf(std::string_view text);

/// Returns the number of pixels (width times height) in the header of a PNG file; 0 if the header
/// is incomplete. Returns nullopt if the file is not a PNG file, or, with `why_not` set, if it
/// cannot be read.
std::optional<std::uint64_t> PngPixels(const std::filesystem::path& file, std::string& why_not);

/// A picture with 8 bits per channel: rows from the top; red, green, blue and, if `has_alpha`,
/// alpha. Colors are not premultiplied by alpha.
struct Pixels {
  int width = 0;
  int height = 0;
  std::span<const std::uint8_t> colors;
  bool has_alpha = false;
};
/// Keywords and texts of the tEXt chunks of a PNG file.
using PngTexts = std::vector<std::pair<std::string, std::string>>;
/// Effort of PNG compression. kSmall tries all row filters of PNG; kFast uses one filter, which
/// takes half of the time and makes the file 5 % larger.
enum class PngEffort { kSmall, kFast };
/// Returns the bytes of a PNG file.
std::string EncodePng(const Pixels& pixels, const PngTexts& texts = {},
                      PngEffort effort = PngEffort::kSmall);

/// A file that an MJCF text refers to.
struct Asset {
  std::string name;                                   // the file's name in the text
  std::filesystem::path file = {};                    // empty if the content is generated
  std::shared_ptr<const std::string> made = nullptr;  // the generated content

  bool operator==(const Asset& other) const {
    return name == other.name && file == other.file &&
           (made == nullptr) == (other.made == nullptr) &&
           (made == nullptr || *made == *other.made);
  }
};
using Assets = std::vector<Asset>;

/// Returns true if the path exists, is a regular file, or is a folder. Links are followed. If the
/// file system cannot tell, returns false.
bool Exists(const std::filesystem::path& path);
bool IsFile(const std::filesystem::path& path);
bool IsFolder(const std::filesystem::path& path);

/// Writes all bytes to a file descriptor; returns false, with errno, if that fails.
bool WriteAll(int descriptor, std::string_view bytes);

/// Returns true for standard input and for a regular file of at most `limit` bytes. Otherwise sets
/// `why_not`.
bool MayRead(const std::filesystem::path& file, std::uint64_t limit, std::string& why_not);

/// If `file` is a pipe, returns a hint to pass "-" (standard input) instead; otherwise an empty
/// text.
std::string PipeHint(const std::filesystem::path& file);

/// Returns true for a regular file of this size. Otherwise sets `why_not` ("it has 12 bytes, not
/// 40").
bool HasSize(const std::filesystem::path& file, std::uint64_t size, std::string& why_not);

/// Incremental 128-bit XXH3 checksum, as printed by `xxh128sum`. Detects the damage that a disk or
/// a power cut causes, at the speed of memory; does not protect against forged data.
class Checksum {
 public:
  Checksum();
  ~Checksum();

  void Add(std::string_view bytes);
  /// Adds the next `count` bytes of a file. Returns false if the file has fewer bytes, or if
  /// reading fails; sets `why_not` only if reading fails.
  bool Add(File& file, std::uint64_t count, std::string& why_not);
  /// Returns the checksum of all bytes added so far, in hexadecimal.
  std::string Text() const;
  void Clear();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the checksum of `bytes`, in hexadecimal.
std::string ChecksumOf(std::string_view bytes);

/// Number of hexadecimal digits of a checksum in the name of a file.
inline constexpr std::size_t kHashDigits = 16;
/// Returns the first digits of the checksum of `bytes`, for the name of a file.
std::string HashOf(std::string_view bytes);

/// Length and checksum of the first bytes of a file, or of a whole file.
struct Fingerprint {
  std::uint64_t size = 0;
  std::string checksum;
};
/// Compares the beginning of a file with each of the fingerprints `prefixes`, which are in
/// ascending order of size. Returns the number of fingerprints before the first one that does not
/// match; 0 if the file cannot be opened.
std::size_t CountSound(const std::filesystem::path& file, std::span<const Fingerprint> prefixes);

enum class Soundness { kSound, kChanged, kUnreadable };
/// Compares a file with its expected size and checksum. Unless both match, sets `why_not` ("it has
/// 12 bytes, not 40", "Too many open files").
Soundness Compare(const std::filesystem::path& file, const Fingerprint& whole,
                  std::string& why_not);
/// Returns true if a file has the expected size and checksum.
bool IsSound(const std::filesystem::path& file, const Fingerprint& whole);

/// Returns the SHA-256 hash of `bytes`, in hexadecimal.
std::string Sha256Of(std::string_view bytes);

}  // namespace mjforge::bytes
