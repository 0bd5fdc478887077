// Terminal cells of UTF-8 characters, and replacement of invalid UTF-8.

#pragma once

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::diag {

/// Returns true for control characters (C0, DEL, C1), line separators and bidirectional controls.
bool ControlsTerminal(char32_t value);

/// The safe text for a character, and its width in columns of a terminal.
struct TerminalCell {
  std::string text;
  int width = 1;
};

/// Returns the cell of the first character of `text`, with the escapes of SafeText.
TerminalCell SafeCell(std::string_view text, Utf8Char character);

/// Returns the text with every invalid byte replaced by U+FFFD.
std::string ValidUtf8(std::string_view text);

}  // namespace mjforge::diag
