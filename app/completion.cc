#include "completion.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>

#include "joint_names.h"
#include "make_options.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

// In the name of a validator is what it offers: its description would be part of error messages.
constexpr std::string_view kOffered = "offered: ";

std::vector<std::string> WordsOf(std::string text) {
  std::istringstream stream(std::move(text));
  return {std::istream_iterator<std::string>(stream), {}};
}

std::vector<std::string> OfferedBy(CLI::Option& option) {
  std::vector<std::string> values;
  try {
    for (int i = 0;; ++i) {
      const std::string& name = option.get_validator(i)->get_name();
      if (name.starts_with(kOffered)) values = WordsOf(name.substr(kOffered.size()));
    }
  } catch (const CLI::OptionNotFound&) {  // that was the last one
  }
  return values;
}

bool TakesValue(const CLI::Option& option) { return option.get_items_expected_min() > 0; }
bool MayRepeat(const CLI::Option& option) { return option.get_items_expected_max() > 1; }

// What the words of a command that are complete say about the next one.
class WordsBefore {
 public:
  WordsBefore(CLI::App& command, const std::vector<std::string>& words) : command_(command) {
    for (const std::string& word : words) Read(word);
  }

  /// The option whose value comes next.
  CLI::Option* pending() const { return pending_; }
  bool options_ended() const { return options_ended_; }
  /// Whether it was given, and once is enough.
  bool IsSpent(const CLI::Option& option) const {
    return given_.contains(&option) && !MayRepeat(option);
  }
  /// The next argument; null if there is none.
  CLI::Option* Argument() const {
    std::size_t before = arguments_.size();
    for (CLI::Option* option : command_.get_options()) {
      if (option->get_positional() && (before-- == 0 || MayRepeat(*option))) return option;
    }
    return nullptr;
  }
  /// The spec that settings are for; empty if there is none.
  std::string Spec() const {
    const std::string what = What();
    return what.ends_with(".xml") ? "" : what;
  }
  /// The spec or file that is looked at; empty if there is none.
  std::string What() const {
    const bool is_there = !arguments_.empty() && arguments_[0] != "-";  // it can be read once
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

  // "-n", "-n5", "-qv"
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

// A text as one line, without what separates it from others.
std::string OneLine(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\t'; }, ' ');
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

class Answer {
 public:
  /// `word`: the one under the cursor.
  explicit Answer(std::string word) : word_(std::move(word)) {}

  const std::string& word() const { return word_; }
  void Add(const std::string& candidate, const std::string& meaning = {}) {
    if (candidate.starts_with(word_) && candidate.find_first_of("\n\t") == std::string::npos)
      text_ += fmt::format("{}\t{}\n", candidate, OneLine(meaning));
  }
  void AddFiles(const std::string& ending) { files_ += (files_.empty() ? "" : " ") + ending; }
  std::string Text() const { return text_ + ":" + files_ + "\n"; }

 private:
  std::string word_;
  std::string text_;
  std::string files_;
};

std::unique_ptr<spec::ObjectSpec> LoadInSilence(const std::string& name) {
  spec::LoadOptions load;
  load.search_path = forge::SearchPath();
  diag::Sources sources;
  diag::Findings findings;
  return spec::LoadSpec(name, load, sources, findings);
}

// Names of the catalogue: whole ones, and the last word alone where it begins as `start`.
void AddSpecs(const std::string& before, const std::string& start, Answer& answer) {
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
  for (const std::string& name : names) {
    const auto spec = LoadInSilence(name);
    answer.Add(before + name, spec ? spec->description : "");
  }
}

// The values of a choice of texts.
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

// "NAME=", or the values of a NAME that is complete.
void AddSetting(const std::string& before, const std::string& name, const std::string& meaning,
                const std::vector<std::string>& values, Answer& answer) {
  const std::string start = before + name + "=";
  if (!answer.word().starts_with(start)) return answer.Add(start, meaning);
  for (const std::string& value : values) answer.Add(start + value);
}

const std::vector<std::string> kTruths = {"true", "false"};

void AddParameters(const std::string& before, const std::string& spec_name, Answer& answer) {
  const auto spec = spec_name.empty() ? nullptr : LoadInSilence(spec_name);
  if (spec == nullptr) return;
  for (const spec::Parameter& parameter : spec->parameters) {
    const bool is_truth = parameter.value.type == expr::Type::kBoolean;
    AddSetting(before, parameter.record.empty() ? parameter.name : parameter.record,
               parameter.doc.empty() ? parameter.source : parameter.doc,
               is_truth ? kTruths : ChoicesOf(parameter.value), answer);
  }
}

void AddThresholds(const std::string& before, Answer& answer) {
  for (const spec::FieldInfo& field : spec::kChecksElement.fields) {
    if (!spec::HoldsValue(field.kind)) continue;
    const bool is_truth = field.kind == spec::FieldKind::kBoolean;
    AddSetting(before, fmt::format("checks.{}", field.key), std::string(field.doc),
               is_truth ? kTruths : WordsOf(std::string(field.words)), answer);
  }
}

// Without the object's prefix, unless the word begins with it.
void AddJoints(const std::string& before, const WordsBefore& line, Answer& answer) {
  if (line.What().empty()) return;
  const std::string start = answer.word().substr(before.size());
  for (const JointName& joint : NamesOfJoints(line.What(), line.settings())) {
    const std::string& name = joint.short_name.starts_with(start) ? joint.short_name : joint.name;
    answer.Add(before + name + (line.IsGiven("--sweep") ? "" : "="), joint.meaning);
  }
}

// `before` is what stands before the value in the word: "--target=".
void AddValues(CLI::Option& option, const std::string& before, const WordsBefore& line,
               Answer& answer) {
  for (const std::string& value : OfferedBy(option)) {
    if (value == "<spec>") {
      AddSpecs(before, answer.word().substr(before.size()), answer);
    } else if (value == "<setting>") {
      AddParameters(before, line.Spec(), answer);
      // There are more of them than of parameters.
      if (line.Spec().empty() || answer.word() != before) AddThresholds(before, answer);
    } else if (value == "<joint>") {
      AddJoints(before, line, answer);
    } else if (value[0] == '.') {
      answer.AddFiles(value);
    } else {
      answer.Add(before + value);
    }
  }
}

void AddOptions(CLI::App& command, const WordsBefore& line, Answer& answer) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || line.IsSpent(*option)) continue;
    const std::string name = option->get_lnames().empty() ? "-" + option->get_snames().front()
                                                          : "--" + option->get_lnames().front();
    answer.Add(WithShortMakeOptions(name), option->get_description());
  }
}

void CompleteCommand(CLI::App& command, const std::vector<std::string>& before, Answer& answer) {
  const WordsBefore line(command, WithLongMakeOptions(before));
  const std::string& word = answer.word();
  const std::size_t equals = word.find('=');
  if (line.pending() != nullptr) {
    AddValues(*line.pending(), "", line, answer);
  } else if (line.options_ended() || !word.starts_with('-')) {
    if (CLI::Option* argument = line.Argument()) AddValues(*argument, "", line, answer);
  } else if (equals == word.npos) {
    AddOptions(command, line, answer);
  } else if (CLI::Option* option = command.get_option_no_throw(word.substr(0, equals))) {
    AddValues(*option, word.substr(0, equals + 1), line, answer);
  }
}

void AddCommands(CLI::App& app, Answer& answer) {
  for (const CLI::App* command : app.get_subcommands({}))
    answer.Add(command->get_name(), command->get_description());
}

// A spec that takes long to load leaves the user alone.
void LimitTime() {
  constexpr ::rlim_t kSeconds = 1;  // of the processor
  const ::rlimit limit = {kSeconds, kSeconds + 1};
  ::setrlimit(RLIMIT_CPU, &limit);
  std::signal(SIGXCPU, [](int) { ::_exit(0); });
}

}  // namespace

CLI::Validator Offers(const std::string& values) {
  const auto accept = [](const std::string&) { return std::string(); };
  return {accept, "", std::string(kOffered) + values};
}

CLI::Validator IsOneOf(std::span<const std::string_view> words) {
  const auto check = [known = std::vector(words.begin(), words.end())](const std::string& text) {
    if (std::ranges::find(known, text) != known.end()) return std::string();
    const std::string meant = diag::DidYouMean(text, known);
    return fmt::format("'{}' is not one of {}{}{}", text, fmt::join(known, ", "),
                       meant.empty() ? "" : "; ", meant);
  };
  return {check, "", fmt::format("{}{}", kOffered, fmt::join(words, " "))};
}

ExitStatus Complete(CLI::App& app, const std::vector<std::string>& words) {
  LimitTime();
  Answer answer(words.empty() ? "" : words.back());
  if (words.size() < 2) {
    AddCommands(app, answer);
    answer.Add("help", "Explain a command");
    if (answer.word().starts_with('-')) AddOptions(app, WordsBefore(app, {}), answer);
  } else if (words[0] == "help") {
    if (words.size() == 2) AddCommands(app, answer);
  } else {
    const auto is_meant = [&](const CLI::App* command) { return command->get_name() == words[0]; };
    for (CLI::App* command : app.get_subcommands(is_meant))
      CompleteCommand(*command, {words.begin() + 1, words.end() - 1}, answer);
  }
  return Print(answer.Text());
}

}  // namespace mjforge::app
