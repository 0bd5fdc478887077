#ifndef MJFORGE_APP_OPTIONS_H_
#define MJFORGE_APP_OPTIONS_H_

// Options that several commands share.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "console.h"
#include "make_options.h"
#include "mjforge/spec/spec.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace mjforge::app {

struct SpecOptions {
  std::vector<std::string> settings;  // name=value
  std::vector<std::string> parameter_files;
};
/// --set NAME=VALUE
void AddSettings(CLI::App& command, std::vector<std::string>& settings, const std::string& doc);
std::vector<spec::Setting> MakeSettings(const std::vector<std::string>& texts);
void AddSpecOptions(CLI::App& command, SpecOptions& options);
spec::LoadOptions MakeLoadOptions(const SpecOptions& options);

/// -q -v --findings --color; `verbose` only where it does something.
void AddReportOptions(CLI::App& command, ReportOptions& options);
void AddVerboseOption(CLI::App& command, ReportOptions& options);

/// A decimal number up to 2^64 - 1, digits only.
std::optional<std::uint64_t> ParseWhole(std::string_view text);
/// -j; 0: not given.
void AddJobs(CLI::App& command, std::uint64_t& jobs);
/// An option that takes a decimal number from `least` to 2^64 - 1.
CLI::Option* AddWholeNumber(CLI::App& command, const std::string& flags, std::uint64_t& value,
                            const std::string& doc, std::uint64_t least = 0);
/// An option that takes one of `words`.
CLI::Option* AddWord(CLI::App& command, const std::string& flags, std::string& value,
                     const std::vector<std::string>& words, const std::string& doc);
/// "Examples:" and the lines, below the help.
void AddExamples(CLI::App& command, const std::string& lines);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_OPTIONS_H_
