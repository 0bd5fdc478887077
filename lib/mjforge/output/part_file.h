#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/output/durability.h"

namespace mjforge::output {

/// A long file under construction. Until Commit() it is called ".NAME.part" in the same folder; it
/// stays there if the process ends, so that a later process can continue it. Only one process at a
/// time can have it open.
class PartFile {
 public:
  /// Takes what an earlier process left, or an empty file. Nothing and a finding if that fails,
  /// another process has it, or something else than a file (a link, a pipe) has its name.
  static std::unique_ptr<PartFile> Open(const std::filesystem::path& file,
                                        diag::Findings& findings);
  /// What `file` is called while it is under construction.
  static std::filesystem::path TemporaryNameOf(const std::filesystem::path& file);
  /// Whether an earlier process left something.
  static bool Exists(const std::filesystem::path& file);

  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  ~PartFile();

  std::uint64_t size() const { return size_; }
  /// Of all its bytes; known once Truncate or Append was called.
  std::string checksum() const { return checksum_.Text(); }
  const std::filesystem::path& temporary() const { return temporary_; }
  bool Append(std::string_view bytes, diag::Findings& findings);
  /// Keeps the first `size` bytes; there must be that many.
  bool Truncate(std::uint64_t size, diag::Findings& findings);
  /// Waits until its bytes are on the disk.
  bool Sync(diag::Findings& findings);
  /// Gives it its final name; with kBatch, once its bytes are on the disk, and waits until the name
  /// is there as well. With `if_changed`, an existing file with the same bytes is left untouched
  /// and this one is removed.
  bool Commit(bool if_changed, Durability durability, diag::Findings& findings);
  /// Removes it.
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
  std::uint64_t writeback_end_ = 0;  // bytes that the system was asked to write
  std::uint64_t reserved_ = 0;       // bytes for which blocks were asked; 0: for none
  bytes::Checksum checksum_;
};

}  // namespace mjforge::output
