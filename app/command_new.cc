// `mjforge new`: a spec to start from, or a copy of another one.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "completion.h"
#include "mjforge/expr/expr.h"
#include "mjforge/forge/forge.h"
#include "usage.h"

namespace mjforge::app {
namespace {

struct NewOptions {
  std::string file;
  std::string like;
  bool force = false;
};

// Returns the name of the object in a file: its stem, with _ for what a name cannot have.
std::string NameFor(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  for (char& c : name) {
    if (!expr::IsName("a" + std::string(1, c))) c = '_';
  }
  return name;
}

ExitStatus WriteNew(const NewOptions& options, Console& console) {
  const std::filesystem::path file = options.file;
  const std::string name = NameFor(file);
  if (file.extension() != ".yaml" && file.extension() != ".yml")
    return WrongUsage(
        fmt::format("the name of a spec ends with .yaml, as in '{}.yaml'", file.string()), "new");
  if (!expr::IsName(name))
    return WrongUsage(fmt::format("'{}' cannot be an object's name; begin with a letter", name),
                      "new");
  std::error_code ignored;
  if (!options.force && std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    console.findings.Add(diag::Code::kOutputExists, {}, fmt::format("'{}' exists", file.string()),
                         "choose another name, or replace the file with --force");
    return console.Report();
  }
  spec::LoadOptions load;
  load.search_path = forge::SearchPath();
  const auto text = options.like.empty()
                        ? spec::StarterText(name, console.sources, console.findings)
                        : spec::CopiedText(options.like, name, file.parent_path(), load,
                                           console.sources, console.findings);
  if (text && output::WriteSingleFile(file, *text, console.findings))
    console.PrintLine(fmt::format("mjforge: note: wrote {}; `mjforge preview {}` draws it",
                                  file.string(), file.string()));
  return console.Report();
}

}  // namespace

Action AddNew(CLI::App& command) {
  auto options = std::make_shared<NewOptions>();
  command.add_option("FILE", options->file, "The spec to write: lamp.yaml")
      ->required()
      ->option_text(" ");
  command.add_option("--like", options->like, "Copy this spec, with another name")
      ->option_text("SPEC")
      ->check(Offers("<spec>"));
  command.add_flag("--force", options->force, "Replace a file that exists");
  return [options](Console& console) { return WriteNew(*options, console); };
}

}  // namespace mjforge::app
