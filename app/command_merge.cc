// `mjforge merge`: joins the manifests of all shards of a batch.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

ExitStatus Merge(const std::string& place, bool verify, Console& console) {
  using Kind = output::Destination::Kind;
  std::string why_not;
  const auto destination = output::ParseDestination(place, 1, why_not);
  if (!destination) return WrongUsage(fmt::format("{}: {}", place, why_not), "merge");
  if (destination->kind != Kind::kFolder && destination->kind != Kind::kArchives &&
      destination->kind != Kind::kFamily) {
    return WrongUsage(
        fmt::format("'{}' is neither a folder, nor a family, nor a series of archives", place),
        "merge");
  }
  const auto count = batch::Merge(*destination, verify, console.sources, console.findings);
  const ExitStatus status = console.Report();
  if (count)
    console.PrintLine(
        fmt::format("{} in {}", Counted(*count, "variant"), destination->Manifest({}).string()));
  return status;
}

}  // namespace

Action AddMerge(CLI::App& command) {
  struct MergeOptions {
    std::string output;
    bool verify = false;
  };
  auto options = std::make_shared<MergeOptions>();
  AddArgument(command, "OUT", options->output, "Where the shards went: the value of generate's -o",
              ".");
  command.add_flag("--verify", options->verify, "Read archives and objects, too");
  return [options](Console& console) { return Merge(options->output, options->verify, console); };
}

}  // namespace mjforge::app
