// Writes the elements of an MJCF text as JSON, for readers without an XML parser.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjforge::xml {

/// Returns the root element as JSON: [tag, {attribute: value, ...}, [child, ...]]. A value is a
/// number, or a list of numbers, if each of its words is a number in JSON; otherwise a text.
/// Returns nullopt if the text is not XML or its elements are nested more than 100 deep.
std::optional<std::string> ElementsJson(std::string_view mjcf);

}  // namespace mjforge::xml
