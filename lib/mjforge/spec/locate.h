#pragma once

// Finds specs and imports.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace mjforge::spec {

/// The file that `reference` names: in `folder`, then in each folder of the
/// search path, with or without `.yaml`; then, for a bare name, anywhere below
/// the search path (the first by folder and name). Nothing if there is none.
std::optional<std::filesystem::path> Locate(const std::string& reference,
                                            const std::filesystem::path& folder,
                                            std::span<const std::filesystem::path> search_path);

/// A hint for a reference that was not found: the nearest bundled name, or how to list them all.
std::string NotFoundHint(const std::string& reference,
                         std::span<const std::filesystem::path> search_path);

/// The path as findings show it: relative to the working folder where it is below it.
std::string DisplayName(const std::filesystem::path& file);

}  // namespace mjforge::spec
