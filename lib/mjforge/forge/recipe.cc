// Loading of recipes (specs from which variants are generated), their names in records, and names
// of objects.

#include <fmt/format.h>

#include <algorithm>

#include "mjforge/bytes/bytes.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

// Returns the path of a file relative to a folder of the search path, without extension; nullopt if
// the file is not in that folder.
std::optional<std::string> NameWithin(const std::filesystem::path& file,
                                      const std::filesystem::path& folder) {
  std::error_code error;
  const auto absolute = std::filesystem::weakly_canonical(file, error);
  const auto root = std::filesystem::weakly_canonical(folder, error);
  if (error) return std::nullopt;
  std::filesystem::path relative = absolute.lexically_relative(root);
  if (relative.empty() || *relative.begin() == "..") return std::nullopt;
  return relative.replace_extension().generic_string();
}

void SetReference(const std::string& given, const std::vector<std::filesystem::path>& search_path,
                  Recipe& recipe) {
  recipe.reference = given;
  if (given == bytes::kStandardInput || recipe.spec->files.empty()) return;
  const std::filesystem::path& file = recipe.spec->files.front();
  for (const std::filesystem::path& folder : search_path) {
    if (auto name = NameWithin(file, folder)) {
      recipe.reference = *std::move(name);
      return;
    }
  }
  recipe.reference = file.filename().string();
  recipe.file = file;
}

std::optional<Recipe> MakeRecipe(std::unique_ptr<spec::ObjectSpec> spec,
                                 const std::string& reference,
                                 const std::vector<std::filesystem::path>& search_path) {
  if (spec == nullptr) return std::nullopt;
  Recipe recipe;
  recipe.spec = std::move(spec);
  SetReference(reference, search_path, recipe);
  for (const auto& [name, text] : recipe.spec->settings) {  // uses the last value of each name
    const auto same =
        std::ranges::find(recipe.settings, name, &std::pair<std::string, std::string>::first);
    if (same == recipe.settings.end()) {
      recipe.settings.emplace_back(name, text);
    } else {
      same->second = text;
    }
  }
  return recipe;
}

spec::Snapshot NewSnapshot(const std::string& reference, const spec::LoadOptions& options) {
  spec::Snapshot snapshot;
  snapshot.spec = reference;
  snapshot.search_path = options.search_path;
  return snapshot;
}

// Returns true if a file of the snapshot was removed or changed since it was read.
bool HasChangedFile(const spec::Snapshot& snapshot) {
  return std::ranges::any_of(snapshot.texts, [](const auto& read) {
    const auto& [file, text] = read;
    if (file == bytes::kStandardInput) return false;
    std::string why_not;
    return !bytes::IsFile(file) || bytes::ReadStart(file, text.size() + 1, why_not) != text;
  });
}

// Returns true if the search path of this process has the same spec under the recipe's name.
bool IsFoundByName(const Recipe& recipe) {
  if (!recipe.file.empty()) return false;
  diag::Sources sources;
  diag::Findings ignored;
  spec::LoadOptions options;
  options.search_path = SearchPath();
  const auto found = spec::LoadSpec(recipe.reference, options, sources, ignored);
  return found && found->sha256 == recipe.spec->sha256;
}

std::optional<Recipe> LoadWith(spec::Snapshot snapshot, spec::LoadOptions options,
                               diag::Sources& sources, diag::Findings& findings) {
  options.snapshot = &snapshot;
  options.search_path = snapshot.search_path;
  std::optional<Recipe> recipe = LoadRecipe(snapshot.spec, options, sources, findings);
  if (recipe && recipe->snapshot.empty() && HasChangedFile(snapshot) && !IsFoundByName(*recipe))
    recipe->snapshot = spec::SnapshotText(snapshot);
  return recipe;
}

}  // namespace

std::optional<Recipe> LoadRecipe(const std::string& reference, const spec::LoadOptions& options,
                                 diag::Sources& sources, diag::Findings& findings) {
  if (options.snapshot == nullptr) {
    const std::size_t before = findings.size();
    std::optional<spec::Snapshot> saved = spec::OpenSnapshot(reference, findings);
    if (findings.size() > before) return std::nullopt;
    if (saved || reference == bytes::kStandardInput)
      return LoadWith(saved ? *std::move(saved) : NewSnapshot(reference, options), options, sources,
                      findings);
  }
  std::optional<Recipe> recipe = MakeRecipe(spec::LoadSpec(reference, options, sources, findings),
                                            reference, options.search_path);
  if (recipe && reference == bytes::kStandardInput)
    recipe->snapshot = spec::SnapshotText(*options.snapshot);
  return recipe;
}

std::string ExpandName(std::string_view text, std::uint64_t index) {
  constexpr std::string_view kIndex = "${index}";
  std::string name;
  for (std::size_t at = text.find(kIndex); at != std::string_view::npos; at = text.find(kIndex)) {
    name += fmt::format("{}{}", text.substr(0, at), index);
    text.remove_prefix(at + kIndex.size());
  }
  return name.append(text);
}

bool CheckName(std::string_view text, diag::Findings& findings) {
  if (expr::IsName(ExpandName(text, 0))) return true;
  findings.Add(diag::Code::kOutputBadName, {}, fmt::format("'{}' cannot be an object's name", text),
               "use a letter, then letters, digits and _; ${index} stands for the variant's index");
  return false;
}

}  // namespace mjforge::forge
