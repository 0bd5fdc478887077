// Tar archives, optionally compressed by Zstandard: writing them in segments, reading their
// members.

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// Formats of archives. The bytes of an archive depend only on the names, contents and order of its
/// members; times and owners are constant.
enum class ArchiveFormat { kTar, kTarZstd };

/// Consecutive members of an archive. An archive is the concatenation of its segments and
/// ArchiveEnd(). In a compressed archive, each segment and the end are separate Zstandard frames,
/// so that several processes can make segments of one archive.
class Segment {
 public:
  explicit Segment(ArchiveFormat format);
  ~Segment();

  /// Adds a regular file with mode 0644. If the name is too long for ustar (100 bytes, 255 with
  /// folders), returns false and adds a finding.
  bool Add(const std::string& name, std::string_view bytes, diag::Findings& findings);
  /// Returns the bytes of the segment, valid until the next Add or Clear; empty if the segment has
  /// no members.
  std::string_view Bytes();
  /// Removes all members.
  void Clear();

 private:
  struct TarWriter;
  std::unique_ptr<TarWriter> tar_;
};

/// Returns the bytes that end an archive.
std::string ArchiveEnd(ArchiveFormat format);

/// Reads the members of an archive of either format one after the other.
class ArchiveReader {
 public:
  /// Opens an archive. If opening fails, the first call of Next fails with the reason.
  explicit ArchiveReader(const std::filesystem::path& file);
  ~ArchiveReader();

  /// Returns the name of the next member. At the end of the archive, or if reading fails, returns
  /// nullopt; sets `why_not` only if reading fails.
  std::optional<std::string> Next(std::string& why_not);
  /// Returns the bytes of the member that Next named; nullopt, and sets `why_not`, if reading
  /// fails. May be called at most once per member.
  std::optional<std::string> Content(std::string& why_not);
  /// Returns at most the first `count` bytes of the member that Next named, up to a zero byte;
  /// fewer if the archive is damaged. May be called once per member, in place of Content.
  std::string ReadStart(std::size_t count);

 private:
  struct TarReader;
  std::unique_ptr<TarReader> tar_;
};

/// Returns true if mjforge wrote the first object of an archive of either format, or if the file
/// has no members, as after a power cut.
bool IsObjectArchive(const std::filesystem::path& file);

/// Returns the bytes of the member `name` of an archive of either format; nullopt, after adding a
/// finding, if the archive does not contain that member or cannot be read.
std::optional<std::string> ReadMember(const std::filesystem::path& file, const std::string& name,
                                      diag::Findings& findings);

}  // namespace mjforge::output
