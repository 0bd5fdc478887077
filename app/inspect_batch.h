#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "console.h"

namespace mjforge::app {

/// The manifest that WHAT names: WHAT itself, or the one in a folder. A name that is both a
/// folder's and a spec's means the spec; with a slash at its end, the folder.
std::optional<std::filesystem::path> FindManifest(const std::string& what);

/// What a batch achieved: how often each choice was drawn, the range and mean of each
/// number.
ExitStatus InspectBatch(const std::filesystem::path& manifest, bool json, Console& console);

}  // namespace mjforge::app
