// The program: words in, words out, exit status.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "commands.h"
#include "interrupt.h"
#include "make_options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

ExitStatus Run(int argc, char** argv) {
  CLI::App app("Randomized MuJoCo objects from declarative YAML specs.", "mjforge");
  app.require_subcommand(1);
  app.set_version_flag("--version", VersionText, "Print versions and exit");
  app.footer("'mjforge COMMAND --help' explains a command and has examples.");
  const std::vector<Action> actions = AddCommands(app);
  try {
    const std::vector<std::string> words = WithLongMakeOptions({argv + 1, argv + argc});
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // as CLI11 takes them
  } catch (const CLI::ParseError& error) {
    return ExplainParseError(app, error, argc > 1 ? argv[1] : "");
  }
  const std::vector<CLI::App*> commands = app.get_subcommands({});
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (commands[i]->parsed()) return actions[i]();
  }
  return ExitStatus::kUsage;
}

ExitStatus Bug(std::string_view what) {
  fmt::print(stderr, "mjforge: internal error: {}\n", what);
  return ExitStatus::kBug;
}

}  // namespace
}  // namespace mjforge::app

int main(int argc, char** argv) {
  using namespace mjforge::app;
  IgnoreWriteSignals();
  try {
    return static_cast<int>(Run(argc, argv));
  } catch (const std::exception& error) {
    return static_cast<int>(Bug(error.what()));
  } catch (...) {
    return static_cast<int>(Bug("unknown"));
  }
}
