// `mjforge report`: writes an HTML page about a batch.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <system_error>
#include <vector>

#include "commands.h"
#include "completion.h"
#include "mjforge/output/output.h"
#include "mjforge/report/report.h"
#include "options.h"
#include "thumbnails.h"
#include "usage.h"

namespace mjforge::app {
namespace {

using Path = std::filesystem::path;

constexpr std::size_t kMaxSuggestions = 3;  // largest number of manifests in a hint

// Returns the complete and partial manifests in the folder, and the manifests of its subfolders.
std::vector<std::string> ManifestsNear(const Path& folder) {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const bool is_folder = entry.is_directory(ignored);
    const Path file = is_folder ? entry.path() / "manifest.jsonl" : entry.path();
    if (output::IsManifest(file.filename().string()) && bytes::IsFile(file))
      found.push_back(file.string());
  }
  std::ranges::sort(found);
  return found;
}

std::string Suggestion(const std::vector<std::string>& manifests) {
  if (manifests.empty()) return "name the folder that 'mjforge generate' wrote to, or a manifest";
  std::string text = "did you mean ";
  const std::size_t shown = std::min(manifests.size(), kMaxSuggestions);
  for (std::size_t i = 0; i < shown; ++i)
    text += fmt::format("{}'{}'", i == 0 ? "" : i + 1 == shown ? " or " : ", ", manifests[i]);
  if (manifests.size() > shown)
    text += fmt::format(", or one of {} more", manifests.size() - shown);
  return text + "?";
}

// Returns the path of the manifest of a batch. `what` names the manifest, the folder or an archive.
// Returns nullopt, after adding a finding, if a folder has no manifest or `what` is something else.
std::optional<Path> FindBatch(const std::string& what, diag::Findings& findings) {
  std::optional<Path> manifest = output::ManifestOf(what);
  const bool is_folder = bytes::IsFolder(what);
  if (manifest && (!is_folder || bytes::IsFile(*manifest))) return manifest;
  if (is_folder) {
    findings.Add(diag::Code::kOutputBadManifest, {},
                 fmt::format("'{}' is not the folder of a batch: it has no manifest.jsonl", what),
                 Suggestion(ManifestsNear(what)));
  } else if (bytes::Exists(what)) {
    const Path folder = Path(what).parent_path();
    findings.Add(diag::Code::kOutputBadManifest, {}, fmt::format("'{}' is not a manifest", what),
                 Suggestion(ManifestsNear(folder.empty() ? "." : folder)));
  } else {
    findings.AddCannotRead(what, "No such file or directory");
  }
  return std::nullopt;
}

// Returns the default file of a report page, beside the manifest of the batch: "out/manifest.jsonl"
// -> "out/report.html", "mugs.manifest.jsonl" -> "mugs.report.html".
Path PageOf(const Path& manifest) {
  constexpr std::string_view kManifest = "manifest";
  std::string name = manifest.filename().string();
  if (name.starts_with('.')) name.erase(0, 1);
  for (const std::string_view ending : {".part", ".zst", ".jsonl"}) {
    if (name.ends_with(ending)) name.resize(name.size() - ending.size());
  }
  if (const std::size_t at = name.rfind(kManifest); at != name.npos) {
    name.replace(at, kManifest.size(), "report");
  } else {
    name += ".report";
  }
  return manifest.parent_path() / (name + ".html");
}

constexpr std::uint64_t kMaxThumbnails = 10'000;  // the size limit of a page is reached earlier

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

ExitStatus Report(const PageOptions& options, Console& console) {
  diag::Findings& findings = console.findings;
  const auto manifest = FindBatch(options.what, findings);
  if (!manifest) return console.Report();
  std::error_code ignored;
  if (std::filesystem::equivalent(*manifest, options.output, ignored))
    return WrongUsage("-o names the manifest itself", "report");
  const bool is_printed = options.output == "-";
  const Path file = options.output.empty() ? PageOf(*manifest) : Path(options.output);
  if (!is_printed && !report::MayReplace(file, options.force, findings)) return console.Report();
  Thumbnails thumbnails(*manifest, options.spec, console.sources);
  const report::Request request{*manifest, options.spec,
                                static_cast<std::size_t>(options.thumbnails)};
  const std::optional<report::Page> page = report::MakePage(
      request, [&](const manifest::Record& record) { return thumbnails.Draw(record); },
      console.sources, findings);
  findings.Append(thumbnails.TakeFindings());
  const bool is_written =
      page && !is_printed && output::WriteSingleFile(file, page->html, findings);
  const ExitStatus status = console.Report();
  if (page && is_printed) return Worse(status, PrintBytes(page->html));
  if (is_written) {
    console.PrintLine(fmt::format("{} of {} variants shown, {} in {}", page->shown, page->variants,
                                  SizeText(page->html.size()), file.string()));
  }
  return status;
}

}  // namespace

Action AddReport(CLI::App& command) {
  auto options = std::make_shared<PageOptions>();
  AddArgument(command, "WHAT", options->what, "The folder, archive or manifest of a batch",
              ".jsonl .tar .zst .part");
  command.add_option("-o,--output", options->output, "The page, or - [beside the manifest]")
      ->option_text("FILE.html")
      ->check(Offers(".html"));
  AddWholeNumber(command, "--thumbnails", options->thumbnails, "Variants to show, at most");
  command.add_option("--spec", options->spec, "The spec, if it has moved")
      ->option_text("SPEC")
      ->check(Offers(kSpecs));
  command.add_flag("--force", options->force, "Overwrite a file that is not a report");
  return [options](Console& console) {
    if (options->thumbnails > kMaxThumbnails)
      return WrongUsage(fmt::format("--thumbnails: at most {}", kMaxThumbnails), "report");
    return Report(*options, console);
  };
}

}  // namespace mjforge::app
