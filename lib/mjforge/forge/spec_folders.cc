// Folders in which specs are looked up by name.

#include <cstdlib>
#include <system_error>

#include "mjforge/forge/forge.h"

namespace mjforge::forge {

std::optional<std::filesystem::path> CatalogueFolder() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  // Searches the parent folders of the program. In an installation, share/ is beside bin/; a build
  // tree has a link to share/ at its top.
  for (std::filesystem::path folder = program.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    const std::filesystem::path specs = folder / "share" / "mjforge" / "specs";
    if (std::filesystem::is_directory(specs, error)) return specs;
  }
  return std::nullopt;
}

std::vector<std::filesystem::path> SearchPath(std::optional<std::filesystem::path> catalogue) {
  std::vector<std::filesystem::path> folders;
  const char* variable = std::getenv("MJFORGE_PATH");
  std::string_view rest = variable == nullptr ? "" : variable;
  while (!rest.empty()) {
    const std::string_view folder = diag::CutAt(':', rest);
    if (!folder.empty()) folders.emplace_back(folder);
  }
  if (catalogue) folders.push_back(*std::move(catalogue));
  return folders;
}

}  // namespace mjforge::forge
