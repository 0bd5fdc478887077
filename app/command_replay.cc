// `mjforge replay`: makes a variant again and compares the bytes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "completion.h"
#include "mjforge/forge/forge.h"
#include "options.h"

namespace mjforge::app {
namespace {

ExitStatus Replay(const forge::ReplayRequest& request, Console& console) {
  const bool same = forge::Replay(request, console.sources, console.findings);
  const ExitStatus status = console.Report();
  if (!same) return Worse(status, ExitStatus::kFindings);
  console.PrintLine(fmt::format("{}: regenerated, same bytes", request.what));
  return status;
}

}  // namespace

Action AddReplay(CLI::App& command) {
  auto request = std::make_shared<forge::ReplayRequest>();
  AddArgument(command, "WHAT", request->what, "BATCH:INDEX (manifest, folder, archive), FILE.xml",
              ".jsonl .zst .xml");
  command.add_option("--spec", request->spec, "The spec, if it has moved")
      ->option_text("SPEC")
      ->check(Offers(kSpecs));
  return [request](Console& console) { return Replay(*request, console); };
}

}  // namespace mjforge::app
