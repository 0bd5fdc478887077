// A long file under construction that a later process can continue.

#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/output/durability.h"

namespace mjforge::output {

/// A long file under construction. Until Commit(), its name is ".NAME.part" in the same folder. The
/// file remains if the process ends, so that a later process can continue it. Only one process at a
/// time can open it.
class PartFile {
 public:
  /// Opens the part that an earlier process left, or a new part. Returns null, after adding a
  /// finding, if that fails, if another process has opened the part, or if its name belongs to a
  /// link, a pipe or a device.
  static std::unique_ptr<PartFile> Open(const std::filesystem::path& file,
                                        diag::Findings& findings);
  /// Returns the temporary name that `file` has while it is under construction.
  static std::filesystem::path TemporaryNameOf(const std::filesystem::path& file);
  /// Returns true if a part of `file` exists, which means that `file` is under construction.
  static bool Exists(const std::filesystem::path& file);

  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  std::uint64_t size() const { return size_; }
  /// Returns the checksum of all bytes. If the part had bytes when it was opened, call Truncate()
  /// first, because Open() does not read the bytes.
  std::string checksum() const { return checksum_.Text(); }
  const std::filesystem::path& final_path() const { return file_; }
  const std::filesystem::path& temporary() const { return temporary_; }
  bool Append(std::string_view bytes, diag::Findings& findings);
  /// Appends the first `count` bytes of another file.
  bool AppendFrom(const std::filesystem::path& file, std::uint64_t count, diag::Findings& findings);
  /// Appends the seek table of a part that consists of Zstandard frames.
  bool AppendSeekTable(diag::Findings& findings);
  /// Keeps the first `size` bytes; the part must have at least `size` bytes.
  bool Truncate(std::uint64_t size, diag::Findings& findings);
  /// Waits until all bytes are on the disk.
  bool Sync(diag::Findings& findings);
  /// Renames the part to its final name. With kBatch, waits before the renaming until the bytes are
  /// on the disk, and afterwards until the name is. With `if_changed`, an existing file with the
  /// same bytes stays untouched, and the part is removed.
  bool Commit(bool if_changed, Durability durability, diag::Findings& findings);
  /// Deletes the file under construction. Has no effect after Commit().
  void Drop();

 private:
  PartFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor,
           std::uint64_t size);
  void Reserve(std::uint64_t end);
  bool ReleaseReserve();

  std::filesystem::path file_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;  // -1: committed or dropped
  std::uint64_t size_ = 0;
  std::uint64_t writeback_end_ = 0;  // end of the bytes whose writeback was requested
  std::uint64_t reserved_ = 0;       // end of the reserved blocks; 0: none were reserved
  bytes::Checksum checksum_;
};

}  // namespace mjforge::output
