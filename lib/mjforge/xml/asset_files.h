// Resolution of the file names of meshes, textures and other assets in an MJCF file.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// Attributes of asset elements that contain the name of a file.
inline constexpr std::string_view kFileAttributes[] = {
    "file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"};
/// Maps the absolute path of a file to the path as messages show it.
using FileNames = std::map<std::string, std::string>;
/// Makes the file names of all assets absolute by MuJoCo's rules, and removes the attributes of
/// <compiler> that these rules use (meshdir, texturedir, strippath). `folder` is the folder of the
/// MJCF file. Adds an error for each file that cannot be read. Returns all files.
FileNames ResolveFiles(XmlElement& root, const std::filesystem::path& folder,
                       diag::Findings& findings);

}  // namespace mjforge::xml
