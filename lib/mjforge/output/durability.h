// Durability of outputs: what a power cut may destroy, and synchronization of folders.

#pragma once

#include <filesystem>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// Data that a power cut may destroy. kNone: all files that the system has not yet written to the
/// disk by itself (up to half a minute of work), even if the files have their final names. kBatch:
/// no file that a manifest lists.
enum class Durability { kNone, kBatch };
inline constexpr std::string_view kDurabilities[] = {"none", "batch"};

/// Waits until the names in a folder are on the disk; with `contents`, also the contents of all
/// files of the folder's file system. On failure, returns false and adds a finding.
bool SyncFolder(const std::filesystem::path& folder, bool contents, diag::Findings& findings);

}  // namespace mjforge::output
