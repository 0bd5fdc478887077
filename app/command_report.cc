#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <system_error>

#include "commands.h"
#include "find_batch.h"
#include "mjforge/output/output.h"
#include "mjforge/report/report.h"
#include "options.h"
#include "thumbnails.h"
#include "usage.h"

namespace mjforge::app {
namespace {

// A page with more of them is full before.
constexpr std::uint64_t kMostThumbnails = 10'000;

struct PageOptions {
  std::string what;
  std::string output;
  std::string spec;
  std::uint64_t thumbnails = 200;
  bool force = false;
};

std::string SizeText(std::size_t bytes) {
  return bytes < 1'000'000 ? fmt::format("{:.0f} kB", static_cast<double>(bytes) / 1e3)
                           : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

// What the page says in a line; empty if there is none.
std::string MakeReport(const PageOptions& options, std::string& html, std::filesystem::path& file,
                       Console& console) {
  diag::Sources& sources = console.sources;
  diag::Findings& findings = console.findings;
  const auto manifest = FindBatch(options.what, findings);
  if (!manifest) return {};
  const bool is_printed = options.output == "-";
  file = options.output.empty() ? PageOf(*manifest) : std::filesystem::path(options.output);
  if (!is_printed && !report::MayReplace(file, options.force, findings)) return {};
  Thumbnails thumbnails(*manifest, options.spec, sources);
  const report::Request request{*manifest, options.spec,
                                static_cast<std::size_t>(options.thumbnails)};
  std::optional<report::Page> page = report::MakePage(
      request, [&](const manifest::Record& record) { return thumbnails.Draw(record); }, sources,
      findings);
  findings.Append(thumbnails.TakeFindings());
  if (!page) return {};
  html = std::move(page->html);
  return fmt::format("{} of {} variants shown, {}", page->shown, page->variants,
                     SizeText(html.size()));
}

ExitStatus Report(const PageOptions& options, Console& console) {
  std::error_code ignored;
  if (std::filesystem::equivalent(options.what, options.output, ignored))
    return WrongUsage("-o names the manifest itself", "report");
  std::string html;
  std::filesystem::path file;
  const std::string words = MakeReport(options, html, file, console);
  const bool is_printed = options.output == "-";
  const bool is_written =
      !words.empty() && !is_printed && output::WriteFile(file, html, false, console.findings);
  ExitStatus status = console.Tell();
  if (!words.empty() && is_printed) status = Worse(status, Print(html));
  if (is_written) console.Say(fmt::format("{} in {}", words, file.string()));
  return status;
}

}  // namespace

Action AddReport(CLI::App& command) {
  auto options = std::make_shared<PageOptions>();
  command.add_option("WHAT", options->what, "The folder, archive or manifest of a batch")
      ->required()
      ->option_text(" ");
  command.add_option("-o,--output", options->output, "The page, or -; else beside the manifest")
      ->option_text("FILE.html");
  AddWholeNumber(command, "--thumbnails", options->thumbnails, "Variants to show, at most");
  command.add_option("--spec", options->spec, "The spec, if it moved since")->option_text("SPEC");
  command.add_flag("--force", options->force, "Overwrite a file that is not a report");
  return [options](Console& console) {
    if (options->thumbnails > kMostThumbnails)
      return WrongUsage(fmt::format("--thumbnails: at most {}", kMostThumbnails), "report");
    return Report(*options, console);
  };
}

}  // namespace mjforge::app
