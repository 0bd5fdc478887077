// Writers of a tree of elements as XML text, with a line for each element or with the lines of the
// original file.
#include "mjforge/xml/element_text.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

namespace mjforge::xml {
namespace {

/// Appends an element and its children to `out`. Calls `start`, which may append line ends, before
/// each element. Writes the generated name of an element without a name.
template <typename Start>
void Write(const XmlElement& element, std::string& out, const Start& start) {
  start(element);
  out += '<';
  out += element.tag;
  const auto write = [&](std::string_view name, const std::string& value) {
    // Replaces control characters by spaces, because XML attributes cannot contain them.
    const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
    std::string text = value;
    std::ranges::replace_if(text, is_control, ' ');
    out += fmt::format(" {}=\"{}\"", name, EscapeXml(text));
  };
  for (const auto& [name, value] : element.attributes) {
    if (name != "name" || element.generated_name.empty()) write(name, value);
  }
  if (!element.generated_name.empty()) write("name", element.generated_name);
  out += '>';
  for (const XmlElement& child : element.children) Write(child, out, start);
  out += fmt::format("</{}>", element.tag);
}

}  // namespace

std::string EscapeXml(std::string_view text) {
  std::string escaped;
  for (const char& c : text) {
    escaped += c == '&'   ? "&amp;"
               : c == '<' ? "&lt;"
               : c == '"' ? "&quot;"
                          : std::string_view(&c, 1);
  }
  return escaped;
}

FlatText Flatten(const XmlElement& root) {
  FlatText flat;
  Write(root, flat.text, [&](const XmlElement& element) {
    if (!flat.lines.empty()) flat.text += '\n';
    flat.lines.push_back(&element);
  });
  return flat;
}

std::string FlattenInPlace(const XmlElement& root) {
  std::string text;
  std::uint32_t line = 1;
  Write(root, text, [&](const XmlElement& element) {
    if (element.mark.file != root.mark.file) return;
    for (; line < element.mark.line; ++line) text += '\n';
  });
  return text;
}

}  // namespace mjforge::xml
