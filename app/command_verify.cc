// `mjforge verify`: compares the files of a batch with its seals (checksums) and records.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "options.h"

namespace mjforge::app {
namespace {

ExitStatus Verify(const std::string& place, Console& console) {
  const batch::VerifyResult verified = batch::Verify(place, console.sources, console.findings);
  const bool is_good = !console.findings.HasErrors();
  const ExitStatus status = StatusOf(console.findings);
  console.Show(console.findings, console.sources, verified.more_findings);
  if (is_good) {
    const std::string variants =
        verified.variants == 0 ? std::string() : ", " + Counted(verified.variants, "variant");
    console.PrintLine(fmt::format("{}: {}{}: as they were when they were made", place,
                                  Counted(verified.files, "file"), variants));
  }
  return status;
}

}  // namespace

Action AddVerify(CLI::App& command) {
  auto what = std::make_shared<std::string>();
  AddArgument(command, "WHAT", *what,
              "A folder, a manifest, a family, an archive, or a series x_%d.tar",
              ".jsonl .npz .tar .zst");
  return [what](Console& console) { return Verify(*what, console); };
}

}  // namespace mjforge::app
