// Durability of outputs: what a power cut may destroy, and synchronization of folders.

#pragma once

#include <filesystem>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// Data that a power cut may destroy. kNone: everything that the system has not written by itself,
/// which is up to half a minute of work, including files under their final names. kBatch: nothing
/// that a manifest lists.
enum class Durability { kNone, kBatch };
inline constexpr std::string_view kDurabilities[] = {"none", "batch"};

/// Waits until the names in a folder are on the disk; with `contents`, also the contents of all
/// files of its file system. If that fails, returns false and adds a finding.
bool SyncFolder(const std::filesystem::path& folder, bool contents, diag::Findings& findings);

}  // namespace mjforge::output
