#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "console.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {

/// The variant must have an object; `sweep` is only there if it was requested.
std::string InspectTables(const forge::Recipe& recipe, const forge::Variant& variant,
                          const std::optional<validate::Sweep>& sweep);
std::string InspectJson(const forge::Recipe& recipe, const forge::Variant& variant,
                        const std::optional<validate::Sweep>& sweep);

std::string InspectTables(const validate::CompiledModel& model,
                          const std::optional<validate::Sweep>& sweep);
std::string InspectJson(const validate::CompiledModel& model,
                        const std::optional<validate::Sweep>& sweep);

/// The manifest that WHAT names: WHAT itself, the one beside an archive, or the one in a folder. A
/// name that is both a folder's and a spec's means the spec; with a slash at its end, the folder.
std::optional<std::filesystem::path> FindManifest(const std::string& what);

/// What a batch achieved: how often each choice was drawn, the range and mean of each
/// number.
ExitStatus InspectBatch(const std::filesystem::path& manifest, bool json, Console& console);

}  // namespace mjforge::app
