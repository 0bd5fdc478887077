#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "mjforge/output/output.h"

namespace mjforge::output {

MadeFolders::~MadeFolders() {
  // rmdir refuses a folder that holds anything.
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
}

bool MadeFolders::Make(const std::filesystem::path& folder, diag::Findings& findings) {
  std::filesystem::path path;
  for (const std::filesystem::path& name : folder) {
    path /= name;
    struct stat status;
    if (::stat(path.c_str(), &status) == 0) {
      if (S_ISDIR(status.st_mode)) continue;
      errno = ENOTDIR;
    } else if (::mkdir(path.c_str(), 0777) == 0) {
      made_.push_back(path);
      continue;
    } else if (errno == EEXIST && ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) {
      continue;  // another process was quicker
    }
    findings.Add(diag::Code::kOutputCannotWrite, {},
                 fmt::format("cannot make folder '{}': {}", path.string(),
                             std::generic_category().message(errno)));
    return false;
  }
  return true;
}

}  // namespace mjforge::output
