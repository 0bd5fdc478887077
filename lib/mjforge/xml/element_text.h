// Conversion of a tree of elements to XML text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// XML text of a tree of elements, in which each element starts on a line of its own. Messages of
/// MuJoCo about a line therefore identify an element.
struct FlatText {
  std::string text;
  // Element that starts on each line of `text`, from line 1 on.
  std::vector<const XmlElement*> lines;
};
FlatText Flatten(const XmlElement& root);
/// Returns XML text in which the elements of the root's file, at least those up to the first
/// include, are on the same lines as in that file.
std::string FlattenInPlace(const XmlElement& root);

/// Returns a text with escapes, for the value of an attribute in double quotes.
std::string EscapeXml(std::string_view text);

}  // namespace mjforge::xml
