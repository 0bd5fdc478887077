// Search for specs and imports by path or name.

#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::spec {

/// Returns the file that `reference` names, with or without `.yaml` or `.yml`: in `folder`, then in
/// each folder of the search path, and then, for a bare name, anywhere below the search path: the
/// first by folder and name, those in `robosuite/` and `scenes/` last. Returns nothing if there is
/// no such file.
std::optional<std::filesystem::path> Locate(const std::string& reference,
                                            const std::filesystem::path& folder,
                                            std::span<const std::filesystem::path> search_path);

/// Returns the paths at which a file that Locate did not find could appear, except below folders of
/// the search path.
std::vector<std::string> Candidates(const std::string& reference,
                                    const std::filesystem::path& folder,
                                    std::span<const std::filesystem::path> search_path);

/// Returns a hint for a reference that was not found: the closest name of a bundled spec, or the
/// command that lists all of them.
std::string NotFoundHint(const std::string& reference,
                         std::span<const std::filesystem::path> search_path);

/// Returns the path as findings show it: relative if the file is below the working folder.
std::string DisplayName(const std::filesystem::path& file);

}  // namespace mjforge::spec
