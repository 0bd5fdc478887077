#pragma once

// Man pages, made from what the help texts are made from.

#include <string>
#include <string_view>

#include "console.h"

namespace CLI {
class App;
}  // namespace CLI

namespace mjforge::app {

inline constexpr std::string_view kWriteManual = "__man";
/// `mjforge __man FOLDER`, for the build: writes mjforge.1 and mjforge-COMMAND.1 for each command.
/// They have no date, so that the same program makes the same bytes.
ExitStatus WriteManualPages(CLI::App& app, const std::string& folder);

}  // namespace mjforge::app
