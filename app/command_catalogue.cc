#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>

#include "commands.h"
#include "json.h"
#include "mjforge/forge/forge.h"
#include "options.h"
#include "table.h"

namespace mjforge::app {
namespace {

struct CatalogueOptions {
  bool json = false;
  ReportOptions report;
};

struct Item {
  std::string name;
  std::string description;
};

std::vector<Item> ListItems(diag::Sources& sources, diag::Findings& findings) {
  spec::LoadOptions load;
  load.search_path = forge::SearchPath();
  std::set<std::string> seen;  // the first folder of the search path wins
  std::vector<Item> items;
  for (const std::filesystem::path& folder : load.search_path) {
    for (const std::string& name : spec::ListSpecs(folder)) {
      if (!seen.insert(name).second) continue;
      const std::unique_ptr<spec::ObjectSpec> spec = spec::LoadSpec(name, load, sources, findings);
      if (spec != nullptr) items.push_back({name, spec->description});
    }
  }
  std::sort(items.begin(), items.end(),
            [](const Item& a, const Item& b) { return a.name < b.name; });
  return items;
}

std::string Text(const std::vector<Item>& items) {
  Table table({"spec", "description"});
  for (const Item& item : items) table.Add({item.name, item.description});
  return table.Render();
}

std::string JsonText(const std::vector<Item>& items) {
  Json json;
  json.StartArray();
  for (const Item& item : items) {
    json.StartObject();
    json.Member("name", item.name);
    json.Member("description", item.description);
    json.EndObject();
  }
  json.EndArray();
  return json.Line();
}

}  // namespace

Action AddCatalogue(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("catalogue", "List the specs that have a name");
  auto options = std::make_shared<CatalogueOptions>();
  command.add_flag("--json", options->json, "One JSON array");
  AddReportOptions(command, options->report);
  AddExamples(command,
              "  mjforge catalogue\n"
              "  MJFORGE_PATH=~/my-specs mjforge catalogue --json");
  return [options] {
    diag::Sources sources;
    diag::Findings findings;
    const std::vector<Item> items = ListItems(sources, findings);
    const ExitStatus status = StatusOf(findings);
    Console(options->report).Show(std::move(findings), sources);
    return Worse(status, Print(options->json ? JsonText(items) : Text(items)));
  };
}

}  // namespace mjforge::app
