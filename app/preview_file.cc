#include "preview_file.h"

#include "mjforge/forge/forge.h"

namespace mjforge::app {

std::string_view PictureSoftware() {
  static const std::string software = "mjforge " + std::string(forge::Version());
  return software;
}

bool MayReplacePicture(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  // Pictures say so before what they show.
  constexpr std::size_t kStart = 8192;
  const auto is_ours = [](std::string_view start) {
    const bool picture = start.starts_with("\x89PNG\r\n") || start.starts_with("GIF89a");
    return picture && start.substr(0, kStart).find("mjforge ") != start.npos;
  };
  return output::MayReplace(file, force, kStart, is_ours, findings);
}

}  // namespace mjforge::app
