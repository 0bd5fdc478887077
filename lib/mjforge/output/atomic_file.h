// Writing a small file so that it appears whole or not at all, and errors of the system as
// findings.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// Returns the final name that belongs to a temporary one of WriteFile: "x.xml" for
/// ".x.xml.tmp123-0"; nothing for all other names.
std::optional<std::string> FinalNameOf(std::string_view temporary);

/// Adds "cannot write 'FILE': WORDS" with the system's words for `error`, an errno.
void AddCannotWrite(const std::filesystem::path& file, int error, diag::Findings& findings);

/// Writes all bytes to an open file. If that fails, returns false and adds that finding about
/// `file`.
bool WriteAll(int descriptor, std::string_view bytes, const std::filesystem::path& file,
              diag::Findings& findings);

}  // namespace mjforge::output
