// The main function: parses the command line and runs a command.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <string>
#include <vector>

#include "child_process.h"
#include "commands.h"
#include "completion.h"
#include "make_rule_options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

ExitStatus Run(int argc, char** argv) {
  CLI::App app("Randomized MuJoCo objects from declarative YAML specs.", "mjforge");
  app.require_subcommand(1);
  app.set_version_flag("--version", VersionText, "Print versions and exit");
  app.footer("'mjforge help COMMAND' explains a command and has examples.");
  MessageOptions report;
  const auto commands = AddCommands(app, report);
  std::vector<std::string> words = WithLongMakeOptions({argv + 1, argv + argc});
  if (argc > 1 && argv[1] == kComplete) return Complete(app, {argv + 2, argv + argc});
  if (!words.empty() && words[0] == "help") {
    words.erase(words.begin());
    const auto is_meant = [&](const auto& row) { return row.first->get_name() == words[0]; };
    if (words.empty() || std::any_of(commands.begin(), commands.end(), is_meant))
      words.emplace_back("--help");
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(),
                                       words.rend()));  // CLI11 takes the words in reverse order
  } catch (const CLI::ParseError& error) {
    return ExplainParseError(app, error, words.empty() ? "" : words[0]);
  }
  for (const auto& [command, action] : commands) {
    Console console(report);
    if (command->parsed()) return action(console);
  }
  return ExitStatus::kUsage;
}

}  // namespace
}  // namespace mjforge::app

int main(int argc, char** argv) {
  using namespace mjforge::app;
  // A closed pipe or a file-size limit makes the write fail instead of ending the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  EndWithParent();
  try {
    return static_cast<int>(Run(argc, argv));
  } catch (const std::exception& error) {
    return static_cast<int>(ExplainException(error));
  }
}
