#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "mjforge/batch/batch.h"
#include "options.h"

namespace mjforge::app {
namespace {

struct CheckOptions {
  std::vector<std::string> specs;
  std::uint64_t count = 20;
  std::uint64_t seed = 0;
  bool physics = false;
  SpecOptions spec;
  ReportOptions report;
};

ExitStatus CheckSpec(const std::string& spec, const CheckOptions& options) {
  Console console(options.report);
  diag::Sources sources;
  diag::Findings findings;
  const std::optional<forge::Recipe> recipe =
      forge::LoadRecipe(spec, MakeLoadOptions(options.spec), sources, findings);
  const ExitStatus status = StatusOf(findings);
  console.Show(std::move(findings), sources);
  if (!recipe) return status;
  batch::Request request;
  request.count = options.count;
  request.variant.seed = options.seed;
  request.variant.batch = options.count;
  if (options.physics) request.variant.validation = forge::Validation::kPhysics;
  const batch::Summary summary = batch::Run(*recipe, sources, request, {});
  console.Show(summary.findings, sources, summary.more_findings);
  console.Say(
      fmt::format("{}: {} of {} variants ok", recipe->spec->file, summary.ok, options.count));
  return summary.failed > 0 ? ExitStatus::kFindings : status;
}

}  // namespace

Action AddCheck(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("check", "Find mistakes in specs; writes nothing");
  auto options = std::make_shared<CheckOptions>();
  command.add_option("SPEC", options->specs, "A file, a name in the catalogue, or - (stdin)")
      ->required()
      ->option_text("...");
  AddWholeNumber(command, "-n,--count", options->count, "Variants to try", 1);
  AddWholeNumber(command, "-s,--seed", options->seed, "Seed of all draws");
  command.add_flag("--physics", options->physics, "Simulate each: does it behave?");
  AddSpecOptions(command, options->spec);
  AddReportOptions(command, options->report);
  AddExamples(command,
              "  mjforge check mug.yaml\n"
              "  mjforge check specs/*.yaml -n 100 --findings json\n"
              "  mjforge check mug.yaml --physics --set checks.stable=true");
  return [options] {
    ExitStatus status = ExitStatus::kDone;
    for (const std::string& spec : options->specs) {
      status = Worse(status, CheckSpec(spec, *options));
    }
    return status;
  };
}

}  // namespace mjforge::app
