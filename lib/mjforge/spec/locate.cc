// Search for specs and imports in the folders of the search path, and names of files in messages.

#include "mjforge/spec/locate.h"

#include <algorithm>
#include <array>
#include <system_error>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/spec/spec.h"
#include "mjforge/spec/yaml.h"

namespace mjforge::spec {
namespace {

namespace fs = std::filesystem;

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error) && !fs::is_directory(path, error);
}

constexpr std::array<std::string_view, 3> kEndings = {"", ".yaml", ".yml"};

std::optional<fs::path> InFolder(const fs::path& folder, const std::string& reference) {
  for (const std::string_view ending : kEndings) {
    const fs::path path = folder / (reference + std::string(ending));
    if (IsFile(path)) return path;
  }
  return std::nullopt;
}

std::vector<fs::path> YamlFilesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const std::string ending = entry->path().extension().string();
    if ((ending == ".yaml" || ending == ".yml") && IsFile(entry->path()))
      files.push_back(entry->path());
  }
  std::ranges::sort(files);
  return files;
}

// Folders whose specs have the same names as specs in other folders: objects of robosuite, and
// scenes. A name without a folder refers to a spec in these folders only if no other spec in the
// same folder of the search path has this name.
constexpr std::array<std::string_view, 2> kSearchedLast = {"robosuite", "scenes"};

std::optional<fs::path> Named(const std::string& name, const fs::path& shelf) {
  std::vector<fs::path> files = YamlFilesBelow(shelf);
  std::erase_if(files, [&](const fs::path& file) { return file.stem() != name; });
  if (files.empty()) return std::nullopt;
  const auto first = std::ranges::find_if(files, [&](const fs::path& file) {
    const std::string folder = file.lexically_relative(shelf).begin()->string();
    return std::ranges::find(kSearchedLast, folder) == kSearchedLast.end();
  });
  return first == files.end() ? files.front() : *first;
}

}  // namespace

std::optional<fs::path> Locate(const std::string& reference, const fs::path& folder,
                               std::span<const fs::path> search_path) {
  if (auto own = InFolder(folder, reference)) return own;
  if (fs::path(reference).is_absolute()) return std::nullopt;
  for (const fs::path& shelf : search_path) {
    if (auto found = InFolder(shelf, reference)) return found;
  }
  if (reference.find('/') != std::string::npos) return std::nullopt;
  for (const fs::path& shelf : search_path) {
    if (auto found = Named(reference, shelf)) return found;
  }
  return std::nullopt;
}

std::vector<std::string> Candidates(const std::string& reference, const fs::path& folder,
                                    std::span<const fs::path> search_path) {
  std::vector<std::string> files;
  const auto add = [&](const fs::path& base) {
    for (const std::string_view ending : kEndings)
      files.push_back((base / (reference + std::string(ending))).string());
  };
  add(folder);
  for (const fs::path& shelf : search_path) add(shelf);
  return files;
}

std::string NotFoundHint(const std::string& reference, std::span<const fs::path> search_path) {
  std::vector<std::string> names;
  for (const fs::path& shelf : search_path) {
    for (std::string& name : ListSpecs(shelf)) {
      names.push_back(fs::path(name).filename().string());
      names.push_back(std::move(name));
    }
  }
  std::string hint = diag::DidYouMean(reference, names);
  return hint.empty() ? "`mjforge catalogue` lists the bundled specs" : hint;
}

std::string DisplayName(const fs::path& file) {
  if (file == bytes::kStandardInput) return "<stdin>";
  std::error_code error;
  const fs::path here = fs::current_path(error);
  if (error || !file.is_absolute()) return file.lexically_normal().string();
  const fs::path relative = file.lexically_relative(here);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return below ? relative.string() : file.lexically_normal().string();
}

std::vector<std::string> ListSpecs(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::path& file : YamlFilesBelow(folder)) {
    std::string why_not;
    const auto text = bytes::ReadStart(file, kMaxYamlBytes, why_not);
    if (!text) continue;
    // Skips files without parts and bodies, because they can only be imported (libraries of
    // materials).
    if (text->find("\nparts:") == std::string::npos &&
        text->find("\nbodies:") == std::string::npos) {
      continue;
    }
    names.push_back(file.lexically_relative(folder).replace_extension().string());
  }
  return names;
}

}  // namespace mjforge::spec
