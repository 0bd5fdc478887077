#include "commands.h"

namespace mjforge::app {

std::vector<Action> AddCommands(CLI::App& app) {
  return {AddGenerate(app), AddCheck(app),     AddInspect(app), AddValidate(app),
          AddPreview(app),  AddView(app),      AddReport(app),  AddMerge(app),
          AddReplay(app),   AddCatalogue(app), AddSchema(app)};
}

}  // namespace mjforge::app
