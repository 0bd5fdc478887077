// Results of `mjforge inspect` as tables and as JSON.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "console.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {

/// Returns tables about a variant, which must have an object. `sweep` is the result of moving the
/// object's joints through their ranges (--sweep).
std::string InspectTables(const forge::Recipe& recipe, const forge::Variant& variant,
                          const std::optional<validate::Sweep>& sweep);
std::string InspectJson(const forge::Recipe& recipe, const forge::Variant& variant,
                        const std::optional<validate::Sweep>& sweep);

/// Returns tables about the model of an MJCF file. `sweep` is as above.
std::string InspectTables(const validate::CompiledModel& model,
                          const std::optional<validate::Sweep>& sweep);
std::string InspectJson(const validate::CompiledModel& model,
                        const std::optional<validate::Sweep>& sweep);

/// Returns the manifest of a batch if `what` is a manifest, an archive or a folder; otherwise
/// nullopt. A spec has priority over a folder of the same name, unless `what` ends with a slash.
std::optional<std::filesystem::path> FindManifest(const std::string& what);

/// Prints statistics of a batch: how often each choice was drawn, range and mean of each number.
ExitStatus InspectBatch(const std::filesystem::path& manifest, bool json, Console& console);

}  // namespace mjforge::app
