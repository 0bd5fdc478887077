#pragma once

// What the fuzz targets share: an input's bytes, a folder for those that read files, and how a
// target says that something is wrong.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::fuzz {

/// An input, taken from its start on. The first bytes choose among options, so that what follows
/// can be a file as it is.
class Input {
 public:
  Input(const std::uint8_t* bytes, std::size_t size)
      : bytes_(reinterpret_cast<const char*>(bytes), size) {}

  /// 0 at the end.
  unsigned Byte();
  /// A number less than `count`.
  std::size_t Below(std::size_t count) { return Byte() % count; }
  bool Bit() { return (Byte() & 1) != 0; }
  /// Up to the next line end, without it.
  std::string_view Line();
  std::string_view Rest() const { return bytes_; }
  bool IsEmpty() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

/// A folder of this process, which has no other files than those put there.
const std::filesystem::path& Folder();
/// Writes a file there and returns its path.
std::filesystem::path Put(const std::string& name, std::string_view bytes);
/// Removes what is in it.
void ClearFolder();

/// The folder of the bundled specs.
std::filesystem::path Specs();

/// The text of a seal with its own checksum in the place of "@own@": without, every change would
/// be found by it and nothing else would be tried.
std::string WithSealChecksum(std::string text);

/// Words the findings for people and for programs, as every command does.
void Word(const diag::Findings& findings, const diag::Sources& sources);

/// Ends the program, as a crash, unless it holds.
void Must(bool holds, std::string_view what);

}  // namespace mjforge::fuzz
