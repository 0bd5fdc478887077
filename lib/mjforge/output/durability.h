#pragma once

#include <filesystem>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// What a cut of the power may take. kNone: what the system has not written by itself, up to half a
/// minute of work and files that look finished; kBatch: nothing that a manifest says is there.
enum class Durability { kNone, kBatch };
inline constexpr std::string_view kDurabilities[] = {"none", "batch"};

/// Waits until the names in a folder are on the disk; with `contents`, the contents of all files of
/// its file system, too. A finding if that fails.
bool SyncFolder(const std::filesystem::path& folder, bool contents, diag::Findings& findings);

}  // namespace mjforge::output
