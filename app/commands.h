// Functions that add the commands of `mjforge` (generate, check, ...) to the command line parser.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "console.h"

namespace CLI {
class App;
}  // namespace CLI

namespace mjforge::app {

/// Runs a command after its options were parsed.
using Action = std::function<ExitStatus(Console&)>;

// Functions that add the options of a command to the parser, and return the action that runs the
// command.
Action AddGenerate(CLI::App& command);
Action AddCheck(CLI::App& command);
Action AddInspect(CLI::App& command);
Action AddValidate(CLI::App& command);
Action AddPreview(CLI::App& command);
Action AddCustomize(CLI::App& command);
Action AddView(CLI::App& command);
Action AddMerge(CLI::App& command);
Action AddVerify(CLI::App& command);
Action AddReplay(CLI::App& command);
Action AddReport(CLI::App& command);
Action AddNew(CLI::App& command);
Action AddCatalogue(CLI::App& command);
Action AddSchema(CLI::App& command);

/// Adds all commands, in the order of the help, with their common options.
std::vector<std::pair<CLI::App*, Action>> AddCommands(CLI::App& app, MessageOptions& report);

}  // namespace mjforge::app
