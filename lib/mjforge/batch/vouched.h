#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"

namespace mjforge::batch {

/// The seal beside a manifest; nothing, and why, if there is none or it is damaged.
std::optional<manifest::Seal> ReadSealOf(const std::filesystem::path& manifest,
                                         std::string& why_not);

/// Whether the file in `folder` is as its seal says: its size or, with `verify`, its bytes; else
/// why not.
bool IsAsSealed(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                std::string& why_not);

/// Whether a record's own file is in `folder` and not empty or, with `verify`, has its hash; else
/// why not.
bool HasObject(const std::filesystem::path& folder, const manifest::Record& record, bool verify,
               std::string& why_not);

/// The same, with a finding if not.
bool CheckSealed(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                 diag::Findings& findings);
bool CheckObject(const std::filesystem::path& folder, const manifest::Record& record, bool verify,
                 diag::Findings& findings);

}  // namespace mjforge::batch
