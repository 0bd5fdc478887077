// Search for places (file, line, column) in XML texts.
#include "mjforge/xml/places.h"

#include <algorithm>

namespace mjforge::xml {

diag::SourceMark MarkAt(const diag::Sources& sources, std::uint32_t source, std::size_t offset) {
  const std::string_view text = sources.Text(source);
  const std::string_view before = text.substr(0, std::min(text.size(), offset));
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return {source, static_cast<std::uint32_t>(1 + std::ranges::count(before, '\n')),
          static_cast<std::uint32_t>(1 + before.size() - line_start)};
}

diag::SourceMark MarkOfLine(const diag::Sources& sources, std::uint32_t source, int line) {
  diag::SourceMark mark{source, static_cast<std::uint32_t>(std::max(line, 1)), 1};
  const std::size_t start = sources.Line(mark).find_first_not_of(" \t");
  if (start != std::string_view::npos) mark.column = static_cast<std::uint32_t>(start + 1);
  return mark;
}

diag::SourceMark MarkOfAttribute(const diag::Sources& sources, const XmlElement& element,
                                 std::string_view attribute) {
  const std::string_view text = sources.Text(element.mark.file);
  std::size_t at = 0;
  for (std::uint32_t line = 1; line < element.mark.line; ++line) at = text.find('\n', at) + 1;
  at += element.mark.column - 1;
  for (char quote = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      break;
    } else if (static_cast<unsigned char>(c) <= ' ' && text.substr(at + 1).starts_with(attribute) &&
               text.find_first_of(" \t\r\n=", at + 1) == at + 1 + attribute.size()) {
      return MarkAt(sources, element.mark.file, at + 1);
    }
  }
  return element.mark;
}

}  // namespace mjforge::xml
