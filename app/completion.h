// Completion of command lines for shells.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "console.h"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace mjforge::app {

/// Argument of Offers for an option that takes a spec: names of the catalogue, and YAML files.
inline constexpr const char* kSpecs = "<spec> .yaml .yml";

/// Returns a validator that accepts every value and declares the completions of an option. `values`
/// contains words separated by spaces. A word is a value, or it stands for values: "<spec>" for
/// names of the catalogue, "<setting>" for NAME=VALUE of the spec on the line, "<joint>" for
/// NAME=VALUE (with --sweep: NAME) of the joints of the spec or file on the line, ".xml" for files
/// with this ending, "." for all files.
CLI::Validator Offers(const std::string& values);
/// Returns a validator that accepts only `words` and declares them as completions. The characters
/// of `words` must live as long as the program.
CLI::Validator IsOneOf(std::span<const std::string_view> words);

inline constexpr std::string_view kComplete = "__complete";
/// `mjforge __complete WORD...`: completes the last of `words`, which are the words between the
/// program's name and the cursor. Prints one line per candidate: the word, a tab, its meaning. The
/// last line is a colon and the endings of files that are candidates, too, separated by spaces; "."
/// means all files. Does not report errors.
ExitStatus Complete(CLI::App& app, const std::vector<std::string>& words);

}  // namespace mjforge::app
