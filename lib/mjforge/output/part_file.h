#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// A long file under construction. Until Commit() it is called ".NAME.part" in the same folder; it
/// stays there if the process ends, so that a later process can continue it. Only one process at a
/// time can have it open.
class PartFile {
 public:
  /// Takes what an earlier process left, or an empty file. Nothing and a finding
  /// if that fails or another process has it.
  static std::unique_ptr<PartFile> Open(const std::filesystem::path& file,
                                        diag::Findings& findings);
  /// What `file` is called while it is under construction.
  static std::filesystem::path NameOf(const std::filesystem::path& file);
  /// Whether an earlier process left something.
  static bool Exists(const std::filesystem::path& file);

  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  std::uint64_t size() const { return size_; }
  const std::filesystem::path& temporary() const { return temporary_; }
  bool Append(std::string_view bytes, diag::Findings& findings);
  /// Keeps the first `size` bytes; there must be that many.
  bool Truncate(std::uint64_t size, diag::Findings& findings);
  /// Gives it its final name. With `if_changed`, an existing file with the same bytes is left
  /// untouched and this one is removed.
  bool Commit(bool if_changed, diag::Findings& findings);
  /// Removes it.
  void Drop();

 private:
  PartFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor,
           std::uint64_t size);

  std::filesystem::path file_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;  // -1: committed or dropped
  std::uint64_t size_ = 0;
};

}  // namespace mjforge::output
