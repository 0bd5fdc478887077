// Options of the command line that several commands share, and the recipes and requests made of
// these options.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "console.h"
#include "mjforge/batch/batch.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace mjforge::app {

/// Options for the values of a spec's parameters.
struct SpecOptions {
  std::uint64_t seed = 0;
  std::optional<std::uint64_t> place_seed;
  std::vector<std::string> settings;  // NAME=VALUE
  std::vector<std::string> parameter_files;

  bool given() const {
    return seed != 0 || place_seed || !settings.empty() || !parameter_files.empty();
  }
};
void AddSpecOptions(CLI::App& command, SpecOptions& options);
spec::LoadOptions LoadOptionsOf(const SpecOptions& options);
/// Loads a spec; returns nullopt and adds findings if it has errors.
std::optional<forge::Recipe> LoadRecipe(const std::string& what, const SpecOptions& options,
                                        Console& console);

/// Returns true if an argument names an MJCF file and not a spec. Decides by the name, or for
/// standard input ("-") by the first character; standard input can still be read afterwards.
bool IsMjcf(const std::string& what);

/// Options of commands for one object: a variant of a spec, or an MJCF file.
struct ObjectOptions {
  std::string what;
  std::uint64_t index = 0;
  SpecOptions spec;
};
void AddObjectOptions(CLI::App& command, ObjectOptions& options, const std::string& doc);
/// Returns the error message for options of a spec that were given for a file or a batch, `what`,
/// which is shown as it is; an empty text if there are none. `numbers` names the command's options
/// for indices and counts of variants; `has_number` is true if one of them was given.
std::string RefuseSpecOptions(const std::string& what, const SpecOptions& options, bool has_number,
                              std::string_view numbers);

/// Options of commands for many variants of specs.
struct BatchOptions {
  std::vector<std::string> specs;
  SpecOptions spec;
  batch::Request request;  // incomplete: see RequestOf
};
void AddBatchOptions(CLI::App& command, BatchOptions& options);
/// Completes the request: sets its seed, and `batch` (the number of variants over which draws are
/// spread) if --batch was not given.
batch::Request RequestOf(const BatchOptions& options);
/// Returns the exit status of a finished or stopped batch.
ExitStatus StatusOf(const batch::Summary& summary);

/// Adds the required argument of a command; `offered` declares its completions (see Offers).
void AddArgument(CLI::App& command, const std::string& name, std::string& value,
                 const std::string& doc, const std::string& offered);
/// Adds a required argument that may be repeated.
void AddArguments(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                  const std::string& doc, const std::string& offered);

/// Adds --jobs, which sets `jobs` to a number of processes.
CLI::Option* AddJobs(CLI::App& command, std::uint64_t& jobs, const std::string& doc);

/// Adds --set NAME=VALUE.
void AddSettings(CLI::App& command, std::vector<std::string>& settings, const std::string& doc);
std::vector<spec::Setting> MakeSettings(const std::vector<std::string>& texts);

/// Adds --profile, which adds a setting and calls `simulate` to enable physical checks.
void AddProfile(CLI::App& command, std::vector<std::string>& settings,
                const std::function<void()>& simulate);

/// Adds --time-limit.
CLI::Option* AddTimeLimit(CLI::App& command, Seconds& limit,
                          const std::string& doc = "CPU time for each, s; wall time 10 S + 5");

/// Adds --quiet, --findings and --color.
void AddMessageOptions(CLI::App& command, MessageOptions& options);

/// Adds an option for a whole number from `least` to `most`.
CLI::Option* AddWholeNumber(CLI::App& command, const std::string& flags, std::uint64_t& value,
                            const std::string& doc, std::uint64_t least = 0,
                            std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
/// Adds an option for a number from `least` to `most`; `what` describes the number in errors.
CLI::Option* AddNumber(CLI::App& command, const std::string& flags,
                       const std::function<void(double)>& assign, double least, double most,
                       const std::string& what, const std::string& doc);
/// Adds an option for one of `words`, whose characters must live as long as the program.
CLI::Option* AddWord(CLI::App& command, const std::string& flags, std::string& value,
                     std::span<const std::string_view> words, const std::string& doc);

}  // namespace mjforge::app
