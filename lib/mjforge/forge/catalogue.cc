#include <cstdlib>
#include <system_error>

#include "mjforge/forge/forge.h"

namespace mjforge::forge {

std::optional<std::filesystem::path> CatalogueFolder() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const std::filesystem::path bin = program.parent_path();
  const std::filesystem::path installed = bin.parent_path() / "share" / "mjforge" / "specs";
  if (std::filesystem::is_directory(installed, error)) return installed;
  // A program run from a build tree inside the source tree.
  for (std::filesystem::path folder = bin; folder.has_relative_path();
       folder = folder.parent_path()) {
    if (std::filesystem::is_directory(folder / "specs", error) &&
        std::filesystem::exists(folder / "schemas" / "object.schema.json", error)) {
      return folder / "specs";
    }
  }
  return std::nullopt;
}

std::vector<std::filesystem::path> SearchPath() {
  std::vector<std::filesystem::path> folders;
  const char* variable = std::getenv("MJFORGE_PATH");
  std::string_view rest = variable == nullptr ? "" : variable;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    if (!folder.empty()) folders.emplace_back(folder);
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
  }
  if (auto bundled = CatalogueFolder()) folders.push_back(*std::move(bundled));
  return folders;
}

}  // namespace mjforge::forge
