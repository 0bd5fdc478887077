#ifndef MJFORGE_APP_VIEWER_H_
#define MJFORGE_APP_VIEWER_H_

#include <filesystem>
#include <optional>

#include "exit_status.h"
#include "mjforge/diag/diag.h"

namespace mjforge::app {

/// A fresh folder among the temporary ones, gone with all that is in it when it ends.
class TemporaryFolder {
 public:
  /// Nothing, and a finding, if it cannot be made.
  static std::optional<TemporaryFolder> Make(diag::Findings& findings);
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
  }
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// MuJoCo's own viewer, by the name it has in Debian, else in MuJoCo's own archives.
/// Nothing, and a finding, if PATH has neither or there is no display.
std::optional<std::filesystem::path> FindViewer(diag::Findings& findings);

/// Shows a file, with `folder` as its working folder, and waits until the viewer
/// ends. SIGINT, SIGTERM and SIGHUP go on to it, the second one as SIGKILL.
ExitStatus RunViewer(const std::filesystem::path& viewer, const std::filesystem::path& file,
                     const std::filesystem::path& folder, diag::Findings& findings);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_VIEWER_H_
