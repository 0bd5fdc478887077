#pragma once

#include <filesystem>
#include <string>

#include "harness/command.h"

namespace mjforge::golden {

/// Runs one line in a shell that finds the mjforge under test first. `merged`:
/// standard error goes to standard output, in the order of a terminal.
harness::CommandResult RunLine(const std::string& line, const std::filesystem::path& folder,
                               bool merged);

/// The text with the seconds that a summary line reports replaced: "(0.3 s)"
/// becomes "(N s)".
std::string WithoutTimes(const std::string& text);

/// Returns true if the mjforge under test has a MuJoCo of 3.0 or later.
bool HasAnotherMujoco();

}  // namespace mjforge::golden
