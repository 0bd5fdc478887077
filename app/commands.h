#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "console.h"

namespace CLI {
class App;
}  // namespace CLI

namespace mjforge::app {

/// What a command does once its options are parsed.
using Action = std::function<ExitStatus(Console&)>;

// Each adds its options to its command and returns what it does.
Action AddGenerate(CLI::App& command);
Action AddCheck(CLI::App& command);
Action AddInspect(CLI::App& command);
Action AddValidate(CLI::App& command);
Action AddPreview(CLI::App& command);
Action AddView(CLI::App& command);
Action AddMerge(CLI::App& command);
Action AddVerify(CLI::App& command);
Action AddReplay(CLI::App& command);
Action AddReport(CLI::App& command);
Action AddCatalogue(CLI::App& command);
Action AddSchema(CLI::App& command);

/// All of them, in the order of the help, with the options that all have.
std::vector<std::pair<CLI::App*, Action>> AddCommands(CLI::App& app, ReportOptions& report);

}  // namespace mjforge::app
