// `mjforge new`: writes a spec to start from, or a copy of another spec.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "completion.h"
#include "mjforge/forge/forge.h"
#include "usage.h"

namespace mjforge::app {
namespace {

struct NewOptions {
  std::string file;
  std::string like;
  bool force = false;
};

ExitStatus WriteNew(const NewOptions& options, Console& console) {
  const std::filesystem::path file = options.file;
  if (file.extension() != ".yaml" && file.extension() != ".yml")
    return WrongUsage(
        fmt::format("the name of a spec ends with .yaml, as in '{}.yaml'", file.string()), "new");
  std::error_code ignored;
  if (!options.force && std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    console.findings.Add(diag::Code::kOutputExists, {}, fmt::format("'{}' exists", file.string()),
                         "choose another name, or replace the file with --force");
    return console.Report();
  }
  const spec::LoadOptions load = {.search_path = forge::SearchPath()};
  const auto text = options.like.empty() ? std::optional(spec::StarterText())
                                         : spec::CopiedText(options.like, file.parent_path(), load,
                                                            console.sources, console.findings);
  if (!text || spec::LoadSpecText(file.string(), *text, file.parent_path(), load, console.sources,
                                  console.findings) == nullptr) {
    return console.Report();
  }
  if (output::WriteSingleFile(file, *text, console.findings))
    console.PrintLine(fmt::format("mjforge: note: wrote {}; `mjforge preview {}` draws it",
                                  file.string(), output::ShellWord(file.string())));
  return console.Report();
}

}  // namespace

Action AddNew(CLI::App& command) {
  auto options = std::make_shared<NewOptions>();
  command.add_option("FILE", options->file, "The spec to write: lamp.yaml")
      ->required()
      ->option_text(" ");
  command.add_option("--like", options->like, "Copy this spec")
      ->option_text("SPEC")
      ->check(Offers("<spec>"));
  command.add_flag("--force", options->force, "Replace a file that exists");
  return [options](Console& console) { return WriteNew(*options, console); };
}

}  // namespace mjforge::app
