// Options of the command line that several commands share, and the recipes and requests made of
// these options.
#include "options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <limits>

#include "completion.h"
#include "mjforge/bytes/bytes.h"
#include "mjforge/expr/expr.h"

namespace mjforge::app {

using namespace std::string_literals;

namespace {

constexpr std::uint64_t kMaxJobs = 1024;

constexpr std::array<std::string_view, 2> kFindings = {"text", "json"};
constexpr std::array<std::string_view, 3> kColors = {"auto", "always", "never"};
constexpr std::array<std::string_view, 2> kRoots = {"free", "none"};
constexpr std::array<std::string_view, 2> kStarts = {"zero", "keyframe"};
constexpr std::array<std::string_view, 2> kProfiles = {"none", "simready"};

std::string CheckSetting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals != std::string::npos && equals > 0) return {};
  return fmt::format("'{}' is not of the form name=value", text);
}

// Adds an option for a number from `least` to `most`, read by `parse`, because CLI11's own
// conversion reads "010" as eight; `what` describes the number in errors.
template <typename Number, typename Assign>
CLI::Option* AddBounded(CLI::App& command, const std::string& flags,
                        std::optional<Number> (*parse)(std::string_view), const Assign& assign,
                        Number least, Number most, const std::string& what,
                        const std::string& doc) {
  const auto read = [=](const std::string& text) {
    const std::optional<Number> number = parse(text);
    return number && *number >= least && *number <= most ? number : std::nullopt;
  };
  const auto check = [=](const std::string& text) {
    return read(text) ? std::string() : fmt::format("'{}' is not {}", text, what);
  };
  const auto set = [=](const std::string& text) { assign(*read(text)); };
  return command.add_option_function<std::string>(flags, set, doc)->check(check);
}

// Adds an option whose value must be one of `words`. Parsing the command line passes the value to
// `set`.
CLI::Option* AddChoice(CLI::App& command, const std::string& flag,
                       std::span<const std::string_view> words, const std::string& doc,
                       const std::function<void(const std::string&)>& set) {
  return command.add_option_function<std::string>(flag, set, doc)
      ->check(IsOneOf(words))
      ->option_text("WORD");
}

void Require(CLI::Option* option, const std::string& text, const std::string& offered) {
  option->required()->option_text(text)->check(Offers(offered));
}

}  // namespace

void AddArgument(CLI::App& command, const std::string& name, std::string& value,
                 const std::string& doc, const std::string& offered) {
  Require(command.add_option(name, value, doc), " ", offered);
}

void AddArguments(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                  const std::string& doc, const std::string& offered) {
  Require(command.add_option(name, values, doc), "...", offered);
}

void AddSettings(CLI::App& command, std::vector<std::string>& settings, const std::string& doc) {
  command.add_option("--set", settings, doc)
      ->option_text("NAME=VALUE")
      ->allow_extra_args(false)
      ->check(CheckSetting)
      ->check(Offers("<setting>"));
}

void AddProfile(CLI::App& command, std::vector<std::string>& settings,
                const std::function<void()>& simulate) {
  AddChoice(command, "--profile", kProfiles, "More tests, by name: simready",
            [&settings, simulate](const std::string& word) {
              settings.push_back("checks.profile=" + word);
              simulate();
            });
}

void AddSpecOptions(CLI::App& command, SpecOptions& options) {
  AddWholeNumber(command, "-s,--seed", options.seed, "Seed of all draws");
  const auto set_place_seed = [&options](std::uint64_t seed) { options.place_seed = seed; };
  AddBounded<std::uint64_t>(command, "--place-seed", output::ReadIndex, set_place_seed, 0,
                            std::numeric_limits<std::uint64_t>::max(), "a whole number from 0 up",
                            "Seed of the draws of `place:` alone")
      ->option_text("N");
  AddSettings(command, options.settings, "Set a parameter, in any form a spec allows");
  AddChoice(command, "--root", kRoots, "Joint of the root: free, none",
            [&options](const auto& word) { options.settings.push_back("root.joints=" + word); });
  AddChoice(command, "--start", kStarts, "Start state: zero, keyframe",
            [&options](const auto& word) { options.settings.push_back("root.start=" + word); });
  command.add_option("--params", options.parameter_files, "Set parameters from a YAML mapping")
      ->option_text("FILE")
      ->allow_extra_args(false)
      ->check(Offers(".yaml .yml"));
}

spec::LoadOptions LoadOptionsOf(const SpecOptions& options) {
  spec::LoadOptions load;
  load.settings = MakeSettings(options.settings);
  load.parameter_files.assign(options.parameter_files.begin(), options.parameter_files.end());
  load.search_path = forge::SearchPath();
  return load;
}

std::optional<forge::Recipe> LoadRecipe(const std::string& what, const SpecOptions& options,
                                        Console& console) {
  return forge::LoadRecipe(what, LoadOptionsOf(options), console.sources, console.findings);
}

bool IsMjcf(const std::string& what) {
  if (what != "-") return what.ends_with(".xml");
  std::string why_not;
  const auto text = bytes::ReadStart(what, bytes::kMaxMjcf, why_not);
  constexpr std::string_view kBlank = " \t\r\n\xef\xbb\xbf";  // white space and the byte-order mark
  const std::size_t first = text ? text->find_first_not_of(kBlank) : std::string::npos;
  return first != std::string::npos && (*text)[first] == '<';
}

void AddObjectOptions(CLI::App& command, ObjectOptions& options, const std::string& doc) {
  AddArgument(command, "WHAT", options.what, doc, kSpecs + " .xml"s);
  AddWholeNumber(command, "--index", options.index, "The variant to show");
  AddSpecOptions(command, options.spec);
}

std::string RefuseSpecOptions(const std::string& what, const SpecOptions& options, bool has_number,
                              std::string_view numbers) {
  if (!options.given() && !has_number) return {};
  return fmt::format(
      "'{}' is shown as it is: --seed, --place-seed, {}, --set, --root, --start and --params take "
      "a spec",
      what, numbers);
}

CLI::Option* AddTimeLimit(CLI::App& command, Seconds& limit, const std::string& doc) {
  const auto set_limit = [&limit](double s) { limit = Seconds(s); };
  return AddNumber(command, "--time-limit", set_limit, 1e-9, 1e9, "a time in seconds above 0", doc)
      ->option_text(fmt::format("S [{:g}]", limit.count()));
}

CLI::Option* AddJobs(CLI::App& command, std::uint64_t& jobs, const std::string& doc) {
  const auto set_jobs = [&jobs](std::uint64_t number) { jobs = number; };
  return AddBounded<std::uint64_t>(command, "-j,--jobs", output::ReadIndex, set_jobs, 1, kMaxJobs,
                                   fmt::format("a number of processes from 1 to {}", kMaxJobs), doc)
      ->option_text("N [cores]");
}

void AddBatchOptions(CLI::App& command, BatchOptions& options) {
  batch::Request& request = options.request;
  AddArguments(command, "SPEC", options.specs, "A file, a name in the catalogue, or - (stdin)",
               kSpecs);
  AddWholeNumber(command, "-n,--count", request.count, "Variants to make", 1);
  AddSpecOptions(command, options.spec);
  AddJobs(command, request.jobs, "Processes that make variants");
  AddTimeLimit(command, request.time_limit, "CPU time per variant, s; wall time 10 S + 5");
}

batch::Request RequestOf(const BatchOptions& options) {
  batch::Request request = options.request;
  request.variant.seed = options.spec.seed;
  request.variant.place_seed = options.spec.place_seed;
  if (request.variant.batch == 0) request.variant.batch = request.count;
  return request;
}

ExitStatus StatusOf(const batch::Summary& summary) {
  if (summary.interrupted) return ExitStatus::kInterrupted;
  if (summary.files_failed) return ExitStatus::kInputOutput;
  const bool nothing = summary.ok == 0 && summary.skipped > 0;
  return summary.failed > 0 || nothing ? ExitStatus::kFindings : ExitStatus::kDone;
}

std::vector<spec::Setting> MakeSettings(const std::vector<std::string>& texts) {
  std::vector<spec::Setting> settings;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    settings.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return settings;
}

void AddMessageOptions(CLI::App& command, MessageOptions& options) {
  AddWord(command, "--findings", options.findings, kFindings, "Format of errors");
  AddWord(command, "--color", options.color, kColors, "Color of errors");
  command.add_flag("-q,--quiet", options.quiet, "Print errors only");
}

CLI::Option* AddWholeNumber(CLI::App& command, const std::string& flags, std::uint64_t& value,
                            const std::string& doc, std::uint64_t least, std::uint64_t most) {
  const auto assign = [&value](std::uint64_t number) { value = number; };
  const std::string end =
      most == std::numeric_limits<std::uint64_t>::max() ? "up" : fmt::format("to {}", most);
  return AddBounded<std::uint64_t>(command, flags, output::ReadIndex, assign, least, most,
                                   fmt::format("a whole number from {} {}", least, end), doc)
      ->option_text(fmt::format("N [{}]", value));
}

CLI::Option* AddNumber(CLI::App& command, const std::string& flags,
                       const std::function<void(double)>& assign, double least, double most,
                       const std::string& what, const std::string& doc) {
  return AddBounded(command, flags, expr::ParseNumber, assign, least, most, what, doc)
      ->option_text("X");
}

CLI::Option* AddWord(CLI::App& command, const std::string& flags, std::string& value,
                     std::span<const std::string_view> words, const std::string& doc) {
  return command.add_option(flags, value, fmt::format("{}: {}", doc, fmt::join(words, ", ")))
      ->check(IsOneOf(words))
      ->option_text(fmt::format("WORD [{}]", value));
}

}  // namespace mjforge::app
