// Writes a tree of elements as XML text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// A tree of elements as one text for MuJoCo, in which each element starts on a line of its own.
struct FlatText {
  std::string text;
  std::vector<const XmlElement*> lines;  // elements that start on lines 1, 2, ... of `text`
};
FlatText Flatten(const XmlElement& root);
/// Returns a text in which the elements of the root's file are on the same lines as in the file, at
/// least up to the first include.
std::string FlattenInPlace(const XmlElement& root);

/// Escapes a text for the value of an attribute in double quotes.
std::string EscapeXml(std::string_view text);

}  // namespace mjforge::xml
