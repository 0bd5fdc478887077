#pragma once

#include <exception>
#include <string_view>

#include "console.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace mjforge::app {

/// "mjforge: error: MESSAGE" and where help is; kUsage.
ExitStatus WrongUsage(std::string_view message, std::string_view command);

/// Prints the help or version that was requested, or explains what was not understood.
ExitStatus ExplainParseError(const CLI::App& app, const CLI::ParseError& error,
                             std::string_view first_word);

/// Says what ended the program: too little memory, a call of the system that failed, or a bug.
ExitStatus ExplainException(const std::exception& exception);

/// The text of --version.
std::string VersionText();

}  // namespace mjforge::app
