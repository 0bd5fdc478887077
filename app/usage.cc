// Messages for wrong command lines, with suggestions, and for exceptions; help and versions.
#include "usage.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <new>
#include <system_error>

#include "console.h"
#include "make_rule_options.h"
#include "mjforge/forge/forge.h"

namespace mjforge::app {
namespace {

std::vector<std::string> CommandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> OptionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string UnexpectedWord(const CLI::App& app, const CLI::App& command) {
  for (const std::string& word : app.remaining(true)) {
    if (word.size() < 2 || word[0] != '-' || word == "--") continue;
    const std::string name = word.substr(0, word.find('='));
    return diag::WithSuggestion(fmt::format("there is no option '{}'", name), name,
                                OptionNames(command));
  }
  std::vector<std::string> words = app.remaining(true);
  std::erase(words, "--");
  return fmt::format("'{}' is one word too many", words.front());
}

// Returns the message of an error, with other words for "--seed: At Most 1 required but received
// 2".
std::string WordsOf(const CLI::ParseError& error) {
  constexpr std::string_view kRepeated = ": At Most 1 required but received ";
  std::string said = error.what();
  const std::size_t at = said.find(kRepeated);
  if (at == said.npos) return said;
  return fmt::format("{} is given {} times", said.substr(0, at),
                     said.substr(at + kRepeated.size()));
}

}  // namespace

ExitStatus WrongUsage(std::string_view message, std::string_view command) {
  const Console console{MessageOptions()};
  console.PrintLine(fmt::format("mjforge: error: {}", message));
  console.PrintLine(
      fmt::format("  hint: see 'mjforge{}{} --help'", command.empty() ? "" : " ", command));
  return ExitStatus::kUsage;
}

ExitStatus ExplainParseError(const CLI::App& app, const CLI::ParseError& error,
                             std::string_view first_word) {
  if (dynamic_cast<const CLI::CallForHelp*>(&error) != nullptr)
    return Print(WithShortMakeOptions(app.help()));
  if (dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr) return Print(VersionText());
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  if (parsed.empty() && !first_word.empty() && first_word[0] != '-') {
    const std::string word(first_word);
    return WrongUsage(diag::WithSuggestion(fmt::format("there is no command '{}'", word), word,
                                           CommandNames(app)),
                      {});
  }
  const CLI::App& command = parsed.empty() ? app : *parsed.back();
  const std::string name = parsed.empty() ? std::string() : command.get_name();
  // Ignores "--", which only ends the options.
  if (std::ranges::any_of(app.remaining(true), [](const auto& word) { return word != "--"; }))
    return WrongUsage(UnexpectedWord(app, command), name);
  if (parsed.empty()) return WrongUsage("a command is missing", {});
  return WrongUsage(WordsOf(error), name);
}

ExitStatus ExplainNoMemory() {
  constexpr std::string_view kMessage = "mjforge: error: not enough memory\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  return ExitStatus::kInputOutput;
}

ExitStatus ExplainException(const std::exception& exception) {
  if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr) return ExplainNoMemory();
  const bool is_system = dynamic_cast<const std::system_error*>(&exception) != nullptr;
  PrintError(fmt::format("{}: {}", is_system ? "error" : "internal error", exception.what()));
  return is_system ? ExitStatus::kInputOutput : ExitStatus::kBug;
}

std::string VersionText() {
  std::string text = fmt::format("mjforge {}\n", forge::Version());
  for (const forge::Library& library : forge::Libraries()) {
    text += fmt::format("{} {}\n", library.name, library.version);
  }
  return text;
}

}  // namespace mjforge::app
