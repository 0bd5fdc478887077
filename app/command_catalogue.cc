// `mjforge catalogue`: lists the specs that can be used by name, as text, JSON or HTML pages.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <set>

#include "commands.h"
#include "completion.h"
#include "gallery.h"
#include "mjforge/forge/forge.h"
#include "options.h"
#include "text_table.h"
#include "usage.h"

namespace mjforge::app {
namespace {

using Item = report::GalleryCard;  // a spec of the catalogue

// Returns true if the name, the description or the parameters of a spec contain every word.
bool HasWords(const Item& item, const std::vector<std::string>& words) {
  const std::string text =
      diag::LowerCase(fmt::format("{}\n{}\n{}", item.name, item.description, item.words));
  return std::ranges::all_of(words, [&](const std::string& word) {
    return text.find(diag::LowerCase(word)) != std::string::npos;
  });
}

Item LoadItem(const std::string& name, const spec::LoadOptions& load, Console& console) {
  Item item;
  item.name = name;
  diag::Findings findings;
  if (const auto spec = spec::LoadSpec(name, load, console.sources, findings)) {
    item.description = spec->description;
    for (const spec::Parameter& parameter : spec->parameters)
      item.words += fmt::format("{} {} ", parameter.name, parameter.doc);
  } else {
    const diag::Finding& first = *findings.FirstError();
    item.problem =
        first.mark ? fmt::format("line {}: {}", first.mark.line, first.message) : first.message;
  }
  console.findings.Append(std::move(findings));
  return item;
}

// Returns the specs in the search path that contain these words, sorted by name. Adds findings for
// specs that cannot be loaded. Such a spec is among the results if its name contains the words.
std::vector<Item> ListItems(const std::vector<std::string>& words, Console& console) {
  const spec::LoadOptions load = {.search_path = forge::SearchPath()};
  std::set<std::string> seen;  // the first folder of the search path has priority
  std::vector<Item> items;
  for (const std::filesystem::path& folder : load.search_path) {
    for (const std::string& name : spec::ListSpecs(folder)) {
      if (!seen.insert(name).second) continue;
      Item item = LoadItem(name, load, console);
      if (HasWords(item, words)) items.push_back(std::move(item));
    }
  }
  std::ranges::sort(items, {}, &Item::name);
  return items;
}

std::string Text(const std::vector<Item>& items) {
  TextTable table({"spec", "description"});
  for (const Item& item : items) {
    if (item.problem.empty()) table.Add({item.name, item.description});
  }
  return table.Render();
}

std::string JsonText(std::vector<Item> items) {
  std::erase_if(items, [](const Item& item) { return !item.problem.empty(); });
  diag::Json json(nullptr);
  json.Each(items, [&](const Item& item) {
    json.Member("name", item.name);
    json.Member("description", item.description);
  });
  return json.Take() + "\n";
}

struct CatalogueOptions {
  std::vector<std::string> words;
  bool json = false;
  bool has_gallery = false;
  GalleryOptions gallery;
};

ExitStatus RunCatalogue(const CatalogueOptions& options, Console& console) {
  if (options.has_gallery && options.gallery.folder.empty())
    return WrongUsage("--html: the name of the folder is empty", "catalogue");
  std::vector<Item> items = ListItems(options.words, console);
  const bool found = !items.empty() || options.words.empty();
  if (!found) {
    console.findings.Add(diag::Code::kSpecNotFound, {},
                         fmt::format("no spec has '{}'", fmt::join(options.words, "' and '")),
                         "`mjforge catalogue` lists all specs");
  }
  if (options.has_gallery && found) {
    std::ranges::stable_sort(items, report::IsBeforeInGallery, &Item::name);
    return WriteGallery(options.gallery, std::move(items), console);
  }
  const ExitStatus status = console.Report();
  if (options.has_gallery) return status;
  return Worse(status, options.json ? PrintBytes(JsonText(items)) : Print(Text(items)));
}

}  // namespace

Action AddCatalogue(CLI::App& command) {
  auto options = std::make_shared<CatalogueOptions>();
  command.add_option("WORD", options->words, "Specs with this in name, text or parameters")
      ->option_text(" ");
  CLI::Option* json = command.add_flag("--json", options->json, "One JSON array");
  CLI::Option* html = command
                          .add_option_function<std::string>(
                              "--html",
                              [options](const std::string& folder) {
                                options->gallery.folder = folder;
                                options->has_gallery = true;
                              },
                              "Write a gallery: pages with pictures of the specs")
                          ->option_text("DIR")
                          ->check(Offers("."))
                          ->excludes(json);
  AddJobs(command, options->gallery.jobs, "--html: processes that draw")->needs(html);
  AddTimeLimit(command, options->gallery.time_limit, "--html: CPU time per spec, s")->needs(html);
  command.add_flag("--force", options->gallery.force, "--html: overwrite any file")->needs(html);
  return [options](Console& console) { return RunCatalogue(*options, console); };
}

}  // namespace mjforge::app
