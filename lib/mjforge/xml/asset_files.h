// Names of the files that the assets of an MJCF file refer to.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// The attributes of assets that name a file.
inline constexpr std::string_view kFileAttributes[] = {
    "file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"};
/// Maps absolute paths to the paths by which messages name the files.
using FileNames = std::map<std::string, std::string>;
/// Makes file names absolute by MuJoCo's rules, and removes the settings of these rules (meshdir,
/// texturedir, strippath). Adds a finding for each file that cannot be read.
FileNames ResolveFiles(XmlElement& root, const std::filesystem::path& folder,
                       diag::Findings& findings);

}  // namespace mjforge::xml
