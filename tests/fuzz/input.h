#pragma once

// Helpers of the fuzz targets: reader of an input's bytes, a folder for targets that read files,
// and assertions.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::fuzz {

/// Reader of a fuzz input, from its start to its end. The first bytes select options, so that the
/// remaining bytes can be an unchanged file.
class Input {
 public:
  Input(const std::uint8_t* bytes, std::size_t size)
      : bytes_(reinterpret_cast<const char*>(bytes), size) {}

  /// Takes the next byte; returns 0 at the end.
  unsigned Byte();
  /// Takes the next byte, and converts it to a number less than `count`, which must not be 0.
  std::size_t Below(std::size_t count) { return Byte() % count; }
  bool Bit() { return (Byte() & 1) != 0; }
  /// Takes the next line from the input, and returns the line without its line end.
  std::string_view Line();
  std::string_view Rest() const { return bytes_; }
  bool IsEmpty() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

/// Returns the temporary folder of this process, which contains only the files written by Put().
const std::filesystem::path& Folder();
/// Writes a file to Folder(), and returns the path of the file.
std::filesystem::path Put(const std::string& name, std::string_view bytes);
/// Removes everything in Folder().
void ClearFolder();

/// Returns the folder of the bundled specs.
std::filesystem::path Specs();

/// Returns the text of a seal in which the seal's own checksum replaces "@own@", because a seal
/// with a wrong checksum would be rejected before the rest of the code is tested.
std::string WithSealChecksum(std::string text);

/// Renders the findings as text and as JSON, like every command. Aborts if the form is wrong.
void Word(const diag::Findings& findings, const diag::Sources& sources);

/// Aborts the program with the message `what`, unless `holds` is true.
void Must(bool holds, std::string_view what);

}  // namespace mjforge::fuzz
