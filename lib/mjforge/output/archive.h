#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// How archives are written. Their bytes depend on names and contents alone: there are no times and
/// no owners, and members are in the order in which they were added.
enum class ArchiveFormat { kTar, kTarZstd };

/// Some members of an archive, one after the other. An archive is its segments and ArchiveEnd(),
/// one after the other; if compressed, each is a separate frame, so that several processes can work
/// on one archive.
class Segment {
 public:
  explicit Segment(ArchiveFormat format);
  ~Segment();
  Segment(const Segment&) = delete;
  Segment& operator=(const Segment&) = delete;

  /// A regular file, mode 0644. A finding if its name is too long for ustar: 100
  /// bytes, with folders 255.
  bool Add(const std::string& name, std::string_view bytes, diag::Findings& findings);
  /// The bytes, until the next Add or Clear. Empty without members.
  std::string_view Bytes();
  /// Starts anew.
  void Clear();

 private:
  struct TarWriter;
  std::unique_ptr<TarWriter> tar_;
};

/// The bytes that end an archive.
std::string ArchiveEnd(ArchiveFormat format);

/// The bytes of the member `name` of an archive, compressed or not; nothing and a
/// finding if there is none or it cannot be read.
std::optional<std::string> ReadMember(const std::filesystem::path& file, const std::string& name,
                                      diag::Findings& findings);

}  // namespace mjforge::output
