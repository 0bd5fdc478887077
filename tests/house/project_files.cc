#include "house/project_files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "harness/source_folder.h"
#include "harness/temporary_folder.h"

namespace mjforge::house {

namespace fs = std::filesystem;

namespace {

std::vector<ProjectFile> ReadProject(const fs::path& top) {
  // As .gitignore has it; .cache is clangd's.
  const std::set<std::string> not_ours = {".git", ".cache", "build", "out"};
  std::vector<ProjectFile> files;
  for (auto entry = fs::recursive_directory_iterator(top);
       entry != fs::recursive_directory_iterator(); ++entry) {
    if (entry.depth() == 0 && not_ours.contains(entry->path().filename().string())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      files.push_back({entry->path().lexically_relative(top).generic_string(),
                       harness::ReadFile(entry->path())});
    }
  }
  std::ranges::sort(files, {}, &ProjectFile::name);
  return files;
}

}  // namespace

const std::vector<ProjectFile>& ProjectFiles() {
  static const std::vector<ProjectFile> files = ReadProject(harness::SourceFolder());
  return files;
}

std::vector<ProjectFile> CppFiles(std::string_view folder) {
  std::vector<ProjectFile> files;
  for (const ProjectFile& file : ProjectFiles()) {
    if (file.name.starts_with(folder) &&
        (file.name.ends_with(".h") || file.name.ends_with(".cc") || file.name.ends_with(".inc"))) {
      files.push_back(file);
    }
  }
  return files;
}

std::vector<std::string_view> Lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<ProjectFile> LibraryAndProgram() {
  std::vector<ProjectFile> files = CppFiles("lib/");
  std::ranges::move(CppFiles("app/"), std::back_inserter(files));
  return files;
}

}  // namespace mjforge::house
