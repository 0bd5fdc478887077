#include "options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

constexpr std::uint64_t kMostJobs = 1024;

std::string CheckSetting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && equals > 0) return {};
  return fmt::format("'{}' is not of the form name=value", text);
}

}  // namespace

void AddSettings(CLI::App& command, std::vector<std::string>& settings, const std::string& doc) {
  command.add_option("--set", settings, doc)
      ->option_text("NAME=VALUE")
      ->allow_extra_args(false)
      ->check(CheckSetting);
}

void AddSpecOptions(CLI::App& command, SpecOptions& options) {
  AddSettings(command, options.settings, "Set a parameter, in any form a spec allows");
  command
      .add_option_function<std::string>(
          "--root",
          [&options](const std::string& word) {
            options.settings.push_back("root.joints=" + word);
          },
          "Joint of the root: free, none")
      ->check(CLI::IsMember({"free", "none"}))
      ->option_text("WORD");
  command.add_option("--params", options.parameter_files, "Set parameters from a YAML mapping")
      ->option_text("FILE")
      ->allow_extra_args(false);
}

std::vector<spec::Setting> MakeSettings(const std::vector<std::string>& texts) {
  std::vector<spec::Setting> settings;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    settings.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return settings;
}

spec::LoadOptions MakeLoadOptions(const SpecOptions& options) {
  spec::LoadOptions load;
  load.settings = MakeSettings(options.settings);
  load.parameter_files.assign(options.parameter_files.begin(), options.parameter_files.end());
  load.search_path = forge::SearchPath();
  return load;
}

// CLI11 would read "010" as eight.
std::optional<std::uint64_t> ParseWhole(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

void AddJobs(CLI::App& command, std::uint64_t& jobs) {
  const auto check = [](const std::string& text) {
    const std::optional<std::uint64_t> number = ParseWhole(text);
    if (number && *number >= 1 && *number <= kMostJobs) return std::string();
    return fmt::format("'{}' is not a number of processes from 1 to {}", text, kMostJobs);
  };
  command
      .add_option_function<std::string>(
          "-j,--jobs", [&jobs](const std::string& text) { jobs = *ParseWhole(text); },
          "Processes that make variants")
      ->check(check)
      ->option_text("N [cores]");
}

void AddReportOptions(CLI::App& command, ReportOptions& options) {
  AddWord(command, "--findings", options.findings, {"text", "json"}, "Form of errors");
  AddWord(command, "--color", options.color, {"auto", "always", "never"}, "Color of errors");
  command.add_flag("-q,--quiet", options.quiet, "Say nothing but errors");
}

void AddVerboseOption(CLI::App& command, ReportOptions& options) {
  command.add_flag("-v,--verbose", options.verbose, "Say a line about each variant");
}

CLI::Option* AddWholeNumber(CLI::App& command, const std::string& flags, std::uint64_t& value,
                            const std::string& doc, std::uint64_t least) {
  const auto assign = [&value](const std::string& text) { value = *ParseWhole(text); };
  const auto check = [least](const std::string& text) {
    const std::optional<std::uint64_t> number = ParseWhole(text);
    if (number && *number >= least) return std::string();
    return fmt::format("'{}' is not a whole number from {} up", text, least);
  };
  return command.add_option_function<std::string>(flags, assign, doc)
      ->check(check)
      ->option_text(fmt::format("N [{}]", value));
}

CLI::Option* AddWord(CLI::App& command, const std::string& flags, std::string& value,
                     const std::vector<std::string>& words, const std::string& doc) {
  const auto check = [words](const std::string& text) {
    if (std::find(words.begin(), words.end(), text) != words.end()) return std::string();
    const std::vector<std::string_view> candidates(words.begin(), words.end());
    const std::string meant = diag::DidYouMean(text, candidates);
    return fmt::format("'{}' is not one of {}{}{}", text, fmt::join(words, ", "),
                       meant.empty() ? "" : "; ", meant);
  };
  return command.add_option(flags, value, fmt::format("{}: {}", doc, fmt::join(words, ", ")))
      ->check(check)
      ->option_text(fmt::format("WORD [{}]", value));
}

void AddExamples(CLI::App& command, const std::string& lines) {
  command.footer("Examples:\n" + lines);
}

}  // namespace mjforge::app
