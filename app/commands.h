#ifndef MJFORGE_APP_COMMANDS_H_
#define MJFORGE_APP_COMMANDS_H_

#include <functional>
#include <vector>

#include "exit_status.h"

namespace CLI {
class App;
}  // namespace CLI

namespace mjforge::app {

/// What a command does once its options are parsed.
using Action = std::function<ExitStatus()>;

// Each adds its subcommand and returns what it does.
Action AddGenerate(CLI::App& app);
Action AddCheck(CLI::App& app);
Action AddInspect(CLI::App& app);
Action AddValidate(CLI::App& app);
Action AddPreview(CLI::App& app);
Action AddView(CLI::App& app);
Action AddMerge(CLI::App& app);
Action AddReplay(CLI::App& app);
Action AddReport(CLI::App& app);
Action AddCatalogue(CLI::App& app);
Action AddSchema(CLI::App& app);

/// All of them, in the order of the help.
std::vector<Action> AddCommands(CLI::App& app);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_COMMANDS_H_
