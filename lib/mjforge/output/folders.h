#ifndef MJFORGE_OUTPUT_FOLDERS_H_
#define MJFORGE_OUTPUT_FOLDERS_H_

#include <filesystem>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::output {

/// Folders made for a batch; those still empty vanish with it.
class MadeFolders {
 public:
  MadeFolders() = default;
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;
  ~MadeFolders();

  /// Makes the folder and those above it that are missing.
  bool Make(const std::filesystem::path& folder, diag::Findings& findings);

 private:
  std::vector<std::filesystem::path> made_;  // outermost first
};

}  // namespace mjforge::output

#endif  // MJFORGE_OUTPUT_FOLDERS_H_
