#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/engine/xml_tree.h"

namespace mjforge::engine {

/// A tree as one text for MuJoCo.
struct FlatText {
  std::string text;
  std::vector<const XmlElement*> lines;  // that starts on line 1, 2, ...
};
/// With at most one element starting per line.
FlatText Flatten(const XmlElement& root);
/// With the elements of the root's file on their own lines, as far as no other file is included
/// before them.
std::string FlattenInPlace(const XmlElement& root);

/// The attributes of assets that name a file.
inline constexpr std::string_view kFileAttributes[] = {
    "file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"};
/// Files as the tree named them, by their absolute paths.
using FileNames = std::map<std::string, std::string>;
/// Makes file names absolute by MuJoCo's rules (meshdir, texturedir, strippath) and removes those
/// settings. Adds a finding for each missing file.
FileNames ResolveFiles(XmlElement& root, const std::filesystem::path& folder,
                       diag::Findings& findings);

}  // namespace mjforge::engine
