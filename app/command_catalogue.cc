// `mjforge catalogue`: the specs that can be used by name.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <set>

#include "commands.h"
#include "json_output.h"
#include "mjforge/forge/forge.h"
#include "text_table.h"

namespace mjforge::app {
namespace {

std::string LowerCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Returns true if the name, the description or the parameters of a spec contain each word.
bool HasWords(const std::string& name, const spec::ObjectSpec& spec,
              const std::vector<std::string>& words) {
  std::string text = name + '\n' + spec.description;
  for (const spec::Parameter& parameter : spec.parameters)
    text += '\n' + parameter.name + ' ' + parameter.doc;
  text = LowerCase(std::move(text));
  return std::ranges::all_of(words, [&](const std::string& word) {
    return text.find(LowerCase(word)) != std::string::npos;
  });
}

// Returns the descriptions of the specs in the search path that have these words, by name.
std::map<std::string, std::string> ListItems(const std::vector<std::string>& words,
                                             Console& console) {
  spec::LoadOptions load;
  load.search_path = forge::SearchPath();
  std::set<std::string> seen;  // the first folder of the search path has priority
  std::map<std::string, std::string> items;
  for (const std::filesystem::path& folder : load.search_path) {
    for (const std::string& name : spec::ListSpecs(folder)) {
      if (!seen.insert(name).second) continue;
      const auto spec = spec::LoadSpec(name, load, console.sources, console.findings);
      if (spec != nullptr && HasWords(name, *spec, words)) items[name] = spec->description;
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
  auto words = std::make_shared<std::vector<std::string>>();
  command.add_option("WORD", *words, "Specs with this in name, text or parameters")
      ->option_text(" ");
  auto json = std::make_shared<bool>(false);
  command.add_flag("--json", *json, "One JSON array");
  return [words, json](Console& console) {
    const auto items = ListItems(*words, console);
    if (items.empty() && !words->empty()) {
      console.findings.Add(diag::Code::kSpecNotFound, {},
                           fmt::format("no spec has '{}'", fmt::join(*words, "' and '")),
                           "`mjforge catalogue` lists all specs");
    }
    const ExitStatus status = console.Report();
    return Worse(status, *json ? PrintBytes(JsonText(items)) : Print(Text(items)));
  };
}

}  // namespace mjforge::app
