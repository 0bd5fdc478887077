// Conversion of MJCF to JSON, for readers that have no XML parser.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjforge::xml {

/// Returns the root element as JSON: [tag, {attribute: value, ...}, [child, ...]]. If all words of
/// an attribute's value are valid numbers in JSON, the value is a number or a list of numbers;
/// otherwise it is a text. Returns nullopt if the text is not XML or its elements are nested more
/// than 100 deep.
std::optional<std::string> ElementsJson(std::string_view mjcf);

}  // namespace mjforge::xml
