// Makes a temporary folder for files that another program reads, and removes it after use.
#include "temporary_folder.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace mjforge::app {

std::shared_ptr<const std::filesystem::path> MakeTemporaryFolder(diag::Findings& findings) {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  std::string name = ((error ? "/tmp" : parent) / "mjforge-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    findings.Add(diag::Code::kOutputCannotWrite, {},
                 fmt::format("cannot make a temporary folder '{}': {}", name,
                             std::generic_category().message(errno)));
    return nullptr;
  }
  return {new std::filesystem::path(name), [](const std::filesystem::path* folder) {
            std::error_code ignored;
            std::filesystem::remove_all(*folder, ignored);
            delete folder;
          }};
}

}  // namespace mjforge::app
