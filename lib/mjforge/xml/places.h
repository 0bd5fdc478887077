// Places (file, line, column) of bytes, lines and attributes of XML texts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/xml/element.h"

namespace mjforge::xml {

/// Returns the place of the byte at `offset` of the text `source` in `sources`.
diag::SourceMark MarkAt(const diag::Sources& sources, std::uint32_t source, std::size_t offset);

/// Returns the place of the first character that is not blank on a line (1-based).
diag::SourceMark MarkOfLine(const diag::Sources& sources, std::uint32_t source, int line);

/// Returns the place of an attribute of an element. Returns the place of the element if the source
/// text does not contain the attribute.
diag::SourceMark MarkOfAttribute(const diag::Sources& sources, const XmlElement& element,
                                 std::string_view attribute);

}  // namespace mjforge::xml
