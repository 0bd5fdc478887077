#pragma once

// What shells ask the program when its user presses Tab.

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

/// Names of specs, and the files of specs.
inline constexpr const char* kSpecs = "<spec> .yaml .yml";

/// For `check` of an option: accepts any value, and says how a shell may complete it. `values`:
/// words one space apart, each a value, except "<spec>" (names of the catalogue), "<setting>"
/// (NAME=VALUE for the spec on the line), "<joint>" (the same for its joints or those of a file,
/// NAME alone with --sweep), ".xml" (files whose names end so) and "." (any file).
CLI::Validator Offers(const std::string& values);
/// The same of a fixed list; accepts nothing else. The words' letters live as long as the program.
CLI::Validator IsOneOf(std::span<const std::string_view> words);

inline constexpr std::string_view kComplete = "__complete";
/// `mjforge __complete WORD...`: the words after the program's name up to the cursor, the last one
/// as far as it is written, maybe empty. Prints a line for each word that may stand there: the
/// word, a tab, what it means. The last line is a colon and the endings of files that may stand
/// there, too, one space apart; "." is any. Says nothing of mistakes.
ExitStatus Complete(CLI::App& app, const std::vector<std::string>& words);

}  // namespace mjforge::app
