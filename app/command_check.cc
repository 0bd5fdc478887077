// `mjforge check`: makes variants of specs without writing them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "confidence.h"
#include "load_time_limit.h"
#include "options.h"

namespace mjforge::app {
namespace {

struct CheckOptions : BatchOptions {
  bool physics = false;
};

ExitStatus CheckSpec(const std::string& spec, const CheckOptions& options, Console& console) {
  const std::optional<forge::Recipe> recipe = [&] {
    const LoadTimeLimit limit(spec, options.request.time_limit, console);
    return LoadRecipe(spec, options.spec, console);
  }();
  const ExitStatus status = console.Report();
  if (!recipe) return status;
  batch::Request request = RequestOf(options);
  if (options.physics) request.variant.validation = forge::Validation::kPhysics;
  const batch::Summary summary = batch::Run(*recipe, console.sources, request, {});
  console.Show(summary.findings, console.sources, summary.more_findings);
  console.PrintLine(
      fmt::format("{}: {} of {} variants ok", recipe->spec->file, summary.ok, request.count));
  // Prints the confidence only if the variants are random and none of the variants failed.
  const bool is_random = recipe->spec->draws.random || recipe->spec->has_place;
  if (is_random && request.count > 1 && summary.ok == request.count)
    console.PrintLine("  " + ConfidenceText(summary.ok));
  return Worse(status, StatusOf(summary));
}

}  // namespace

Action AddCheck(CLI::App& command) {
  auto options = std::make_shared<CheckOptions>();
  options->request.count = 20;
  AddBatchOptions(command, *options);
  command.add_flag("--physics", options->physics, "Simulate each: does it behave?");
  AddProfile(command, options->spec.settings, [options] { options->physics = true; });
  return [options](Console& console) {
    ExitStatus status = ExitStatus::kDone;
    for (const std::string& spec : options->specs)
      status = Worse(status, CheckSpec(spec, *options, console));
    return status;
  };
}

}  // namespace mjforge::app
