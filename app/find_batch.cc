#include "find_batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "mjforge/output/output.h"

namespace mjforge::app {
namespace {

using Path = std::filesystem::path;

// A suggestion of more is a list to read through.
constexpr std::size_t kMaxSuggestions = 3;

bool IsManifest(std::string_view name) {
  return name.ends_with(".jsonl") || name.ends_with(".jsonl.part");
}

bool IsFile(const Path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

// Manifests in the folder, done or not, and those of the folders in it.
std::vector<std::string> ManifestsNear(const Path& folder) {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const bool is_folder = entry.is_directory(ignored);
    const Path file = is_folder ? entry.path() / "manifest.jsonl" : entry.path();
    if (IsManifest(file.filename().string()) && IsFile(file)) found.push_back(file.string());
  }
  std::sort(found.begin(), found.end());
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

}  // namespace

std::optional<Path> FindBatch(const std::string& what, diag::Findings& findings) {
  std::error_code ignored;
  if (std::filesystem::is_directory(what, ignored)) {
    Path manifest = Path(what) / "manifest.jsonl";
    if (IsFile(manifest)) return manifest;
    findings.Add(diag::Code::kOutputBadManifest, {},
                 fmt::format("'{}' is not the folder of a batch: it has no manifest.jsonl", what),
                 Suggestion(ManifestsNear(what)));
    return std::nullopt;
  }
  if (IsManifest(what)) return what;
  std::string why_not;
  const auto destination = output::ParseDestination(what, 1, why_not);
  if (destination && destination->IsArchive()) return destination->Manifest({});
  if (!std::filesystem::exists(what, ignored)) {
    findings.Add(diag::Code::kYamlCannotRead, {},
                 fmt::format("cannot read '{}': No such file or directory", what));
    return std::nullopt;
  }
  const Path folder = Path(what).parent_path();
  findings.Add(diag::Code::kOutputBadManifest, {}, fmt::format("'{}' is not a manifest", what),
               Suggestion(ManifestsNear(folder.empty() ? "." : folder)));
  return std::nullopt;
}

Path PageOf(const Path& manifest) {
  constexpr std::string_view kManifest = "manifest";
  std::string name = manifest.filename().string();
  if (name.ends_with(".part")) name.resize(name.size() - 5);
  if (name.starts_with('.')) name.erase(0, 1);
  if (name.ends_with(".jsonl")) name.resize(name.size() - 6);
  if (const std::size_t at = name.rfind(kManifest); at != name.npos) {
    name.replace(at, kManifest.size(), "report");
  } else {
    name += ".report";
  }
  return manifest.parent_path() / (name + ".html");
}

}  // namespace mjforge::app
