#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "mjforge/forge/forge.h"
#include "options.h"

namespace mjforge::app {
namespace {

struct ReplayOptions {
  forge::ReplayRequest request;
  ReportOptions report;
};

ExitStatus Replay(const ReplayOptions& options) {
  diag::Sources sources;
  diag::Findings findings;
  const bool same = forge::Replay(options.request, sources, findings);
  const ExitStatus status = StatusOf(findings);
  Console console(options.report);
  console.Show(std::move(findings), sources);
  if (!same) return Worse(status, ExitStatus::kFindings);
  console.Say(fmt::format("{}: made again, same bytes", options.request.what));
  return status;
}

}  // namespace

Action AddReplay(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("replay", "Make a variant again and compare the bytes");
  auto options = std::make_shared<ReplayOptions>();
  command.add_option("WHAT", options->request.what, "MANIFEST:INDEX or a generated FILE.xml")
      ->required()
      ->option_text(" ");
  command.add_option("--spec", options->request.spec, "The spec, if it moved since")
      ->option_text("SPEC");
  AddReportOptions(command, options->report);
  AddExamples(command,
              "  mjforge replay out/manifest.jsonl:42\n"
              "  mjforge replay out/hammer_000042.xml --spec old/hammer.yaml");
  return [options] { return Replay(*options); };
}

}  // namespace mjforge::app
