#ifndef MJFORGE_APP_PREVIEW_FILE_H_
#define MJFORGE_APP_PREVIEW_FILE_H_

#include <filesystem>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::app {

/// What the file of a picture says of itself under "Software".
std::string_view PictureSoftware();

/// True if nothing would be lost by writing a picture there: there is no file, it
/// is a picture that mjforge made, or `force` says so. Else a finding.
bool MayReplacePicture(const std::filesystem::path& file, bool force, diag::Findings& findings);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_PREVIEW_FILE_H_
