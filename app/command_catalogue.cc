// `mjforge catalogue`: the specs that can be used by name.
#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <set>

#include "commands.h"
#include "json_output.h"
#include "mjforge/forge/forge.h"
#include "text_table.h"

namespace mjforge::app {
namespace {

// Returns the descriptions of all specs in the search path, by name.
std::map<std::string, std::string> ListItems(Console& console) {
  spec::LoadOptions load;
  load.search_path = forge::SearchPath();
  std::set<std::string> seen;  // the first folder of the search path has priority
  std::map<std::string, std::string> items;
  for (const std::filesystem::path& folder : load.search_path) {
    for (const std::string& name : spec::ListSpecs(folder)) {
      if (!seen.insert(name).second) continue;
      const auto spec = spec::LoadSpec(name, load, console.sources, console.findings);
      if (spec != nullptr) items[name] = spec->description;
    }
  }
  return items;
}

std::string Text(const std::map<std::string, std::string>& items) {
  TextTable table({"spec", "description"});
  for (const auto& [name, description] : items) table.Add({name, description});
  return table.Render();
}

std::string JsonText(const std::map<std::string, std::string>& items) {
  JsonOutput json;
  json.StartArray();
  for (const auto& [name, description] : items) {
    json.StartObject();
    json.Member("name", name);
    json.Member("description", description);
    json.EndObject();
  }
  json.EndArray();
  return json.Take() + "\n";
}

}  // namespace

Action AddCatalogue(CLI::App& command) {
  auto json = std::make_shared<bool>(false);
  command.add_flag("--json", *json, "One JSON array");
  return [json](Console& console) {
    const auto items = ListItems(console);
    const ExitStatus status = console.Report();
    return Worse(status, *json ? PrintBytes(JsonText(items)) : Print(Text(items)));
  };
}

}  // namespace mjforge::app
