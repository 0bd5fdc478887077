#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mjforge::house {

struct ProjectFile {
  std::string name;  // from the project's top: "lib/mjforge/diag/diag.h"
  std::string text;
};

/// The project's own files, sorted by name: all but what is built, made or kept by git.
const std::vector<ProjectFile>& ProjectFiles();

/// Those in `folder` ("lib/"), of C++ only.
std::vector<ProjectFile> CppFiles(std::string_view folder);

/// C++ files of the library and the program.
std::vector<ProjectFile> LibraryAndProgram();

std::vector<std::string_view> Lines(std::string_view text);

}  // namespace mjforge::house
