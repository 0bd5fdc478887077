// File names of the assets in an MJCF file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// The attributes of assets that contain the name of a file.
inline constexpr std::string_view kFileAttributes[] = {
    "file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"};
/// Maps the absolute path of a file to the path that messages show.
using FileNames = std::map<std::string, std::string>;
/// Makes the file names of assets absolute by MuJoCo's rules, and removes the compiler settings of
/// these rules (meshdir, texturedir, strippath). Adds a finding for each file that cannot be read.
FileNames ResolveFiles(XmlElement& root, const std::filesystem::path& folder,
                       diag::Findings& findings);

}  // namespace mjforge::xml
