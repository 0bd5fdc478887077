// Writers of a tree of elements as XML text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// XML text of a tree of elements for MuJoCo, in which each element starts on a separate line.
struct FlatText {
  std::string text;
  // Lines[i] is the element that starts on line i + 1 of `text`.
  std::vector<const XmlElement*> lines;
};
FlatText Flatten(const XmlElement& root);
/// Returns XML text in which the elements of the root's file are on the same lines as in the file,
/// at least up to the first include.
std::string FlattenInPlace(const XmlElement& root);

/// Escapes a text for the value of an attribute in double quotes.
std::string EscapeXml(std::string_view text);

}  // namespace mjforge::xml
