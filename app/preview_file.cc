#include "preview_file.h"

#include "mjforge/forge/forge.h"

namespace mjforge::app {

std::string_view PictureSoftware() {
  static const std::string software = "mjforge " + std::string(forge::Version());
  return software;
}

bool MayReplacePicture(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  std::error_code error;
  if (force || std::filesystem::symlink_status(file, error).type() ==
                   std::filesystem::file_type::not_found) {
    return true;
  }
  // Pictures say so before what they show.
  constexpr std::size_t kStart = 8192;
  const auto start = output::ReadStart(file, kStart);
  const bool picture = start && (start->starts_with("\x89PNG\r\n") || start->starts_with("GIF89a"));
  if (picture && start->substr(0, kStart).find("mjforge ") != std::string::npos) return true;
  output::AddForeign(file, findings);
  return false;
}

}  // namespace mjforge::app
