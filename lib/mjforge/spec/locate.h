// Search for specs and imports by path or name.

#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::spec {

/// Returns the file that `reference` names, with or without `.yaml` or `.yml`. Searches `folder`,
/// then each folder of the search path. Finally, if `reference` is a name without a folder,
/// searches all files below each folder of the search path in sorted order, but the files in
/// `robosuite/` and `scenes/` last. Returns nullopt if no file is found.
std::optional<std::filesystem::path> Locate(const std::string& reference,
                                            const std::filesystem::path& folder,
                                            std::span<const std::filesystem::path> search_path);

/// Returns the paths in `folder` and in the folders of the search path at which Locate() would find
/// a file of this name. After Locate() failed, a program can watch these paths until the file
/// appears.
std::vector<std::string> Candidates(const std::string& reference,
                                    const std::filesystem::path& folder,
                                    std::span<const std::filesystem::path> search_path);

/// Returns a hint for a reference that was not found: the closest name of a bundled spec, or the
/// command that lists all of them.
std::string NotFoundHint(const std::string& reference,
                         std::span<const std::filesystem::path> search_path);

/// Returns the path as findings show it: relative if the file is below the working folder;
/// "<stdin>" for standard input.
std::string DisplayName(const std::filesystem::path& file);

}  // namespace mjforge::spec
