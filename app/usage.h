// Functions that print errors of the command line, help and versions, and explain exceptions.
#pragma once

#include <exception>
#include <string_view>

#include "console.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace mjforge::app {

/// Prints "mjforge: error: MESSAGE" and a hint to the command's help; returns kUsage.
ExitStatus WrongUsage(std::string_view message, std::string_view command);

/// Prints the help or version that was requested, or the error in the command line.
ExitStatus ExplainParseError(const CLI::App& app, const CLI::ParseError& error,
                             std::string_view first_word);

/// Prints the reason why the program ends: not enough memory, a failed system call, or a bug.
ExitStatus ExplainException(const std::exception& exception);

/// Prints that there is not enough memory, without allocating any; returns kInputOutput.
ExitStatus ExplainNoMemory();

/// Returns the output of --version.
std::string VersionText();

}  // namespace mjforge::app
