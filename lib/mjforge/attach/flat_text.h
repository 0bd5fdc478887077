#ifndef MJFORGE_ATTACH_FLAT_TEXT_H_
#define MJFORGE_ATTACH_FLAT_TEXT_H_

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "mjforge/attach/xml_tree.h"

namespace mjforge::attach {

/// A tree as one text for MuJoCo, with one element's start a line.
struct FlatText {
  std::string text;
  std::vector<const XmlElement*> lines;  // of line 1, 2, ...

  /// The element that starts on a line; null if none does.
  const XmlElement* OnLine(int line) const;
};
FlatText Flatten(const XmlElement& root);

/// Gives elements without a name one that no other has, so that they can be
/// found among what MuJoCo compiled.
void NameElements(XmlElement& root);

/// Files as the tree named them, by their absolute paths.
using FileNames = std::map<std::string, std::string>;
/// Makes file names absolute by MuJoCo's rules (meshdir, texturedir, strippath)
/// and takes those settings out. Adds a finding for each file that is not there.
FileNames ResolveFiles(XmlElement& root, const std::filesystem::path& folder,
                       diag::Findings& findings);

/// A name for everything that MuJoCo calls by its file: the name without
/// folders and ending.
std::string FileStem(const std::string& file);

}  // namespace mjforge::attach

#endif  // MJFORGE_ATTACH_FLAT_TEXT_H_
