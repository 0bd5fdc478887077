// Helpers of atomic writing: names of temporary files, and findings for errors.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// Returns the final name for a temporary name that WriteFile() gave: "x.xml" for
/// ".x.xml.tmp123-0". Returns nullopt for other names.
std::optional<std::string> FinalNameOf(std::string_view temporary);

/// Number of bytes read from an object's file to find its first comment, which contains all
/// settings.
inline constexpr std::size_t kCommentBytes = 64 * 1024;

/// Adds the finding "cannot write 'FILE': MESSAGE" with the system's message for `error`, an errno.
/// Returns false.
bool AddCannotWrite(const std::filesystem::path& file, int error, diag::Findings& findings);

}  // namespace mjforge::output
