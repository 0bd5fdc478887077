// Completion of command lines: options, values, specs, parameters and joints.
#include "completion.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <ctime>
#include <memory>
#include <set>

#include "joint_names.h"
#include "make_rule_options.h"
#include "mjforge/expr/expr.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

// Prefix of the names of CLI11 validators that declare the completions of an option. Completions
// are not in a validator's description, because descriptions appear in error messages.
constexpr std::string_view kOffered = "offered: ";

std::vector<std::string_view> OfferedBy(CLI::Option& option) {
  std::vector<std::string_view> values;
  try {
    for (int i = 0;; ++i) {
      const std::string_view name = option.get_validator(i)->get_name();
      if (name.starts_with(kOffered)) values = expr::WordsOf(name.substr(kOffered.size()));
    }
  } catch (const CLI::OptionNotFound&) {  // there are no more validators
  }
  return values;
}

bool TakesValue(const CLI::Option& option) { return option.get_items_expected_min() > 0; }
bool MayRepeat(const CLI::Option& option) { return option.get_items_expected_max() > 1; }

// The complete words of a command line before the cursor: options, arguments and settings.
class CommandLine {
 public:
  CommandLine(CLI::App& command, const std::vector<std::string>& words) : command_(command) {
    for (const std::string& word : words) Read(word);
  }

  /// The option whose value is next; null if there is none.
  CLI::Option* pending() const { return pending_; }
  bool options_ended() const { return options_ended_; }
  /// Returns true if the option was given and cannot be repeated.
  bool IsSpent(const CLI::Option& option) const {
    return given_.contains(&option) && !MayRepeat(option);
  }
  /// Returns the next positional argument; null if there is none.
  CLI::Option* Argument() const {
    std::size_t before = arguments_.size();
    for (CLI::Option* option : command_.get_options()) {
      if (option->get_positional() && (before-- == 0 || MayRepeat(*option))) return option;
    }
    return nullptr;
  }
  /// Returns the spec to which settings apply; empty if there is none.
  std::string Spec() const {
    const std::string what = What();
    return what.ends_with(".xml") ? "" : what;
  }
  /// Returns the spec or file of the command; empty if there is none.
  std::string What() const {
    // Standard input is ignored, because it can be read only once.
    const bool is_there = !arguments_.empty() && arguments_[0] != "-";
    return is_there ? arguments_[0] : "";
  }
  const std::vector<std::string>& settings() const { return settings_; }
  bool IsGiven(const std::string& option) const {
    return given_.contains(command_.get_option_no_throw(option));
  }

 private:
  void Read(const std::string& word) {
    if (pending_ != nullptr) {
      if (pending_->check_lname("set")) settings_.push_back(word);
      pending_ = nullptr;
    } else if (options_ended_ || word.size() < 2 || word[0] != '-') {
      arguments_.push_back(word);
    } else if (word == "--") {
      options_ended_ = true;
    } else if (word[1] == '-') {
      const std::size_t equals = word.find('=');
      const std::string name = word.substr(0, equals);
      if (name == "--set" && equals != word.npos) settings_.push_back(word.substr(equals + 1));
      Give(command_.get_option_no_throw(name), equals == word.npos);
    } else {
      ReadShort(word);
    }
  }

  // Reads a word of short options: "-n", "-n5" or "-qv".
  void ReadShort(const std::string& word) {
    for (std::size_t i = 1; i < word.size(); ++i) {
      CLI::Option* option = command_.get_option_no_throw({'-', word[i]});
      Give(option, i + 1 == word.size());
      if (option == nullptr || TakesValue(*option)) return;
    }
  }

  void Give(CLI::Option* option, bool value_follows) {
    if (option == nullptr) return;
    given_.insert(option);
    if (value_follows && TakesValue(*option)) pending_ = option;
  }

  CLI::App& command_;
  CLI::Option* pending_ = nullptr;
  std::vector<std::string> arguments_;
  std::vector<std::string> settings_;
  std::set<const CLI::Option*> given_;
  bool options_ended_ = false;
};

class Completions {
 public:
  /// Collects completions of `word`, the word under the cursor.
  explicit Completions(std::string word) : word_(std::move(word)) {}

  const std::string& word() const { return word_; }
  void Add(const std::string& candidate, const std::string& meaning = {}) {
    if (candidate.starts_with(word_) && diag::SafeText(candidate) == candidate)
      text_ += fmt::format("{}\t{}\n", candidate, OneLine(meaning));
  }
  void AddFiles(const std::string& ending) { files_ += (files_.empty() ? "" : " ") + ending; }
  std::string Text() const { return text_ + ":" + files_ + "\n"; }

 private:
  std::string word_;
  std::string text_;
  std::string files_;
};

// CPU time for descriptions of specs, in ticks: half a second.
constexpr std::clock_t kDescriptionTime = CLOCKS_PER_SEC / 2;

std::unique_ptr<spec::ObjectSpec> LoadQuietly(const std::string& name) {
  const spec::LoadOptions load = {.search_path = forge::SearchPath()};
  diag::Sources sources;
  diag::Findings findings;
  return spec::LoadSpec(name, load, sources, findings);
}

// Adds the names of specs in the catalogue that begin with `start`, and last parts of names
// ("hammer") that begin with `start`. `before` is the part of the word before the value: "--spec=".
void AddSpecs(const std::string& before, const std::string& start, Completions& completions) {
  std::set<std::string> names;
  for (const std::filesystem::path& folder : forge::SearchPath()) {
    for (std::string& name : spec::ListSpecs(folder)) {
      const std::string last = name.substr(name.rfind('/') + 1);
      if (name.starts_with(start)) {
        names.insert(std::move(name));
      } else if (last.starts_with(start)) {
        names.insert(last);
      }
    }
  }
  // Adds further names without descriptions if the catalogue takes too long to load.
  const std::clock_t end = std::clock() + kDescriptionTime;
  for (const std::string& name : names) {
    const auto spec = std::clock() < end ? LoadQuietly(name) : nullptr;
    completions.Add(before + name, spec ? spec->description : "");
  }
}

// Returns the texts among which a random parameter is chosen; empty for other parameters.
std::vector<std::string> ChoicesOf(const spec::Value& value) {
  std::vector<std::string> choices;
  const auto* draw = std::get_if<spec::Draw>(&value.form);
  if (draw == nullptr || draw->distribution != spec::Distribution::kChoice) return choices;
  for (const spec::Value& option : draw->arguments) {
    const auto* text = std::get_if<spec::Text>(&option.form);
    if (text != nullptr && text->pieces.size() == 1) choices.push_back(text->pieces[0].literal);
  }
  return choices;
}

// Adds "NAME=" or, if the word already contains "NAME=", the values of the setting.
void AddSetting(const std::string& before, const std::string& name, const std::string& meaning,
                const std::vector<std::string>& values, Completions& completions) {
  const std::string start = before + name + "=";
  if (!completions.word().starts_with(start)) return completions.Add(start, meaning);
  for (const std::string& value : values) completions.Add(start + value);
}

const std::vector<std::string> kBooleans = {"true", "false"};

void AddParameters(const std::string& before, const std::string& spec_name,
                   Completions& completions) {
  const auto spec = spec_name.empty() ? nullptr : LoadQuietly(spec_name);
  if (spec == nullptr) return;
  for (const spec::Parameter& parameter : spec->parameters) {
    const bool is_boolean = parameter.value.type == expr::Type::kBoolean;
    AddSetting(before, parameter.record.empty() ? parameter.name : parameter.record,
               parameter.doc.empty() ? parameter.source : parameter.doc,
               is_boolean ? kBooleans : ChoicesOf(parameter.value), completions);
  }
}

void AddThresholds(const std::string& before, Completions& completions) {
  for (const spec::FieldInfo& field : spec::kChecksElement.fields) {
    if (!spec::HoldsValue(field.kind)) continue;
    const bool is_boolean = field.kind == spec::FieldKind::kBoolean;
    const auto words = expr::WordsOf(field.words);
    AddSetting(before, fmt::format("checks.{}", field.key), std::string(field.doc),
               is_boolean ? kBooleans : std::vector<std::string>(words.begin(), words.end()),
               completions);
  }
}

// Adds the names of joints: the short name (without the object's prefix), or the whole name of a
// joint whose short name does not begin with the typed text.
void AddJoints(const std::string& before, const CommandLine& line, Completions& completions) {
  if (line.What().empty()) return;
  const std::string start = completions.word().substr(before.size());
  for (const JointName& joint : NamesOfJoints(line.What(), line.settings())) {
    const std::string& name = joint.short_name.starts_with(start) ? joint.short_name : joint.name;
    completions.Add(before + name + (line.IsGiven("--sweep") ? "" : "="), joint.meaning);
  }
}

// Adds the values of an option. `before` is the part of the word before the value: "--target=".
void AddValues(CLI::Option& option, const std::string& before, const CommandLine& line,
               Completions& completions) {
  for (const std::string_view value : OfferedBy(option)) {
    if (value == "<spec>") {
      AddSpecs(before, completions.word().substr(before.size()), completions);
    } else if (value == "<setting>") {
      AddParameters(before, line.Spec(), completions);
      // Thresholds of checks are many: adds them only if there is no spec, or after the value's
      // first character.
      if (line.Spec().empty() || completions.word() != before) AddThresholds(before, completions);
    } else if (value == "<joint>") {
      AddJoints(before, line, completions);
    } else if (value[0] == '.') {
      completions.AddFiles(std::string(value));
    } else {
      completions.Add(before + std::string(value));
    }
  }
}

void AddOptions(CLI::App& command, const CommandLine& line, Completions& completions) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || line.IsSpent(*option)) continue;
    const std::string name = option->get_lnames().empty() ? "-" + option->get_snames().front()
                                                          : "--" + option->get_lnames().front();
    completions.Add(WithShortMakeOptions(name), option->get_description());
  }
}

void CompleteCommand(CLI::App& command, const std::vector<std::string>& before,
                     Completions& completions) {
  const CommandLine line(command, WithLongMakeOptions(before));
  const std::string& word = completions.word();
  const std::size_t equals = word.find('=');
  if (line.pending() != nullptr) {
    AddValues(*line.pending(), "", line, completions);
  } else if (line.options_ended() || !word.starts_with('-')) {
    if (CLI::Option* argument = line.Argument()) AddValues(*argument, "", line, completions);
  } else if (equals == word.npos) {
    AddOptions(command, line, completions);
  } else if (CLI::Option* option = command.get_option_no_throw(word.substr(0, equals))) {
    AddValues(*option, word.substr(0, equals + 1), line, completions);
  }
}

void AddCommands(CLI::App& app, Completions& completions) {
  for (const CLI::App* command : app.get_subcommands({}))
    completions.Add(command->get_name(), command->get_description());
}

// Ends the program without completions if loading a spec takes too long.
void LimitTime() {
  constexpr ::rlim_t kSeconds = 1;       // CPU time
  constexpr unsigned kWallSeconds = 10;  // generous, because the machine may be busy
  const ::rlimit limit = {kSeconds, kSeconds + 1};
  ::setrlimit(RLIMIT_CPU, &limit);
  for (const int signal : {SIGXCPU, SIGALRM}) std::signal(signal, [](int) { ::_exit(0); });
  ::alarm(kWallSeconds);
}

}  // namespace

CLI::Validator Offers(const std::string& values) {
  const auto accept = [](const std::string&) { return std::string(); };
  return {accept, "", std::string(kOffered) + values};
}

CLI::Validator IsOneOf(std::span<const std::string_view> words) {
  const auto check = [known = std::vector(words.begin(), words.end())](const std::string& text) {
    if (std::ranges::find(known, text) != known.end()) return std::string();
    return diag::WithSuggestion(fmt::format("'{}' is not one of {}", text, fmt::join(known, ", ")),
                                text, known);
  };
  return {check, "", fmt::format("{}{}", kOffered, fmt::join(words, " "))};
}

ExitStatus Complete(CLI::App& app, const std::vector<std::string>& words) {
  LimitTime();
  Completions completions(words.empty() ? "" : words.back());
  if (words.size() < 2) {
    AddCommands(app, completions);
    completions.Add("help", "Explain a command");
    if (completions.word().starts_with('-')) AddOptions(app, CommandLine(app, {}), completions);
  } else if (words[0] == "help") {
    if (words.size() == 2) AddCommands(app, completions);
  } else {
    const auto is_meant = [&](const CLI::App* command) { return command->get_name() == words[0]; };
    for (CLI::App* command : app.get_subcommands(is_meant))
      CompleteCommand(*command, {words.begin() + 1, words.end() - 1}, completions);
  }
  return PrintBytes(completions.Text());
}

}  // namespace mjforge::app
