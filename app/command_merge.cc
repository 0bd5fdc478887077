#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "mjforge/batch/batch.h"
#include "options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

struct MergeOptions {
  std::string output;
  ReportOptions report;
};

ExitStatus Merge(const MergeOptions& options) {
  using Kind = output::Destination::Kind;
  std::string why_not;
  const auto destination = output::ParseDestination(options.output, 1, why_not);
  if (!destination) return WrongUsage(fmt::format("{}: {}", options.output, why_not), "merge");
  if (destination->kind != Kind::kFolder && destination->kind != Kind::kArchives) {
    return WrongUsage(
        fmt::format("'{}' is neither a folder nor a series of archives", options.output), "merge");
  }
  diag::Sources sources;
  diag::Findings findings;
  const std::optional<std::uint64_t> count = batch::Merge(*destination, sources, findings);
  const ExitStatus status = StatusOf(findings);
  Console console(options.report);
  console.Show(std::move(findings), sources);
  if (count)
    console.Say(fmt::format("{} variants in {}", *count, destination->Manifest({}).string()));
  return status;
}

}  // namespace

Action AddMerge(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("merge", "Join the manifests of all shards of a batch");
  auto options = std::make_shared<MergeOptions>();
  command.add_option("OUT", options->output, "Where the shards went, as generate's -o says it")
      ->required()
      ->option_text(" ");
  AddReportOptions(command, options->report);
  AddExamples(command,
              "  mjforge merge out/\n"
              "  mjforge merge 'hammers_%05d.tar.zst'");
  return [options] { return Merge(*options); };
}

}  // namespace mjforge::app
