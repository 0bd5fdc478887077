// NumPy's archives of arrays (.npz), written member by member in constant memory.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/output/part_file.h"

namespace mjforge::output {

/// Types of NumPy's arrays, little-endian. A text has a constant number of code points.
enum class ArrayType { kFloat64, kInt32, kUint64, kBool, kByte, kText };

/// Converts a UTF-8 text to `length` code points of four bytes each, as NumPy stores texts. A
/// shorter text is filled with zeros; a longer text is cut off.
std::string Utf32Of(std::string_view text, std::size_t length);
/// Returns the number of code points of a UTF-8 text.
std::size_t CodePoints(std::string_view text);

/// Writes an .npz file: a zip file of uncompressed members, each an array in NumPy's format 1.0.
/// The bytes depend only on names and content.
class NpzWriter {
 public:
  /// Writes to `part`, which must be empty and outlive the writer.
  NpzWriter(PartFile& part, diag::Findings& findings);
  ~NpzWriter();

  /// Begins the array `name`, whose content Write adds in C order. `code_points` is the length of
  /// each text.
  void Begin(const std::string& name, ArrayType type, std::span<const std::uint64_t> shape,
             std::size_t code_points = 0);
  void Write(std::string_view bytes);
  void Write(std::span<const double> numbers);
  /// Ends the file. Returns false, after adding a finding, if any call failed.
  bool Finish();

 private:
  struct Zip;
  std::unique_ptr<Zip> zip_;
};

/// Returns true if the file is empty or an .npz file whose first member has this name.
bool IsNpzWith(const std::filesystem::path& file, std::string_view first_member);

}  // namespace mjforge::output
