#pragma once

// Options that several commands share.

#include <chrono>
#include <cstdint>
#include <functional>
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

/// How a spec's parameters get their values.
struct SpecOptions {
  std::uint64_t seed = 0;
  std::vector<std::string> settings;  // name=value
  std::vector<std::string> parameter_files;

  bool given() const { return seed != 0 || !settings.empty() || !parameter_files.empty(); }
};
void AddSpecOptions(CLI::App& command, SpecOptions& options);
/// Loads the spec of that name; nothing, and findings, if it has errors.
std::optional<forge::Recipe> LoadRecipe(const std::string& what, const SpecOptions& options,
                                        Console& console);

/// Whether a command-line argument names an MJCF file and not a spec: judged by its name, or for
/// standard input ("-") by its first character. Standard input can then be read any number of
/// times.
bool IsMjcf(const std::string& what);

/// Whether a file's name is that of a manifest, done or under construction.
inline bool IsManifest(std::string_view name) {
  return name.ends_with(".jsonl") || name.ends_with(".jsonl.part");
}

/// One variant of a spec, or a file.
struct OneOptions {
  std::string what;
  std::uint64_t index = 0;
  SpecOptions spec;
};
void AddOneOptions(CLI::App& command, OneOptions& options, const std::string& doc);

/// Many variants of specs.
struct ManyOptions {
  std::vector<std::string> specs;
  SpecOptions spec;
  batch::Request request;  // seed and batch: see RequestOf
};
void AddManyOptions(CLI::App& command, ManyOptions& options);
/// The request with its seed, and with draws spread over its variants unless --batch was given.
batch::Request RequestOf(const ManyOptions& options);
/// Of a batch that came to its end, or was stopped.
ExitStatus StatusOf(const batch::Summary& summary);

/// --set NAME=VALUE
void AddSettings(CLI::App& command, std::vector<std::string>& settings, const std::string& doc);
std::vector<spec::Setting> MakeSettings(const std::vector<std::string>& texts);

/// --profile, a setting, too; `simulate` is to ask for physical checks.
void AddProfile(CLI::App& command, std::vector<std::string>& settings,
                const std::function<void()>& simulate);

/// --time-limit
void AddTimeLimit(CLI::App& command, std::chrono::duration<double>& limit,
                  const std::string& doc = "CPU time for each, s; wall time 10 S + 5");

/// -q --findings --color
void AddReportOptions(CLI::App& command, ReportOptions& options);

/// A decimal number up to 2^64 - 1, digits only.
std::optional<std::uint64_t> ParseWhole(std::string_view text);
/// An option that takes a decimal number from `least` to 2^64 - 1.
CLI::Option* AddWholeNumber(CLI::App& command, const std::string& flags, std::uint64_t& value,
                            const std::string& doc, std::uint64_t least = 0);
/// An option that takes a number from `least` to `most`; `what` describes it in errors.
CLI::Option* AddNumber(CLI::App& command, const std::string& flags,
                       const std::function<void(double)>& assign, double least, double most,
                       const std::string& what, const std::string& doc);
/// An option that takes one of `words`, whose letters live as long as the program.
CLI::Option* AddWord(CLI::App& command, const std::string& flags, std::string& value,
                     std::span<const std::string_view> words, const std::string& doc);

}  // namespace mjforge::app
