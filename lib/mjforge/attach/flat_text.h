#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mjforge/attach/xml_tree.h"

namespace mjforge::attach {

/// A tree as one text for MuJoCo, with at most one element starting per line.
struct FlatText {
  std::string text;
  std::vector<const XmlElement*> lines;  // of line 1, 2, ...

  /// The element that starts on a line; null if none does.
  const XmlElement* OnLine(int line) const;
};
FlatText Flatten(const XmlElement& root);

/// Gives each element without a name a unique one, so that it can be found among what MuJoCo
/// compiled.
void NameElements(XmlElement& root);

/// Files as the tree named them, by their absolute paths.
using FileNames = std::map<std::string, std::string>;
/// Makes file names absolute by MuJoCo's rules (meshdir, texturedir, strippath) and removes those
/// settings. Adds a finding for each missing file.
FileNames ResolveFiles(XmlElement& root, const std::filesystem::path& folder,
                       diag::Findings& findings);

/// The name that MuJoCo gives to something named after its file: the file name without folders and
/// extension.
std::string FileStem(const std::string& file);

}  // namespace mjforge::attach
