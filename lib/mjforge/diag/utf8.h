// Width of UTF-8 characters in a terminal, and replacement of invalid UTF-8.

#pragma once

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::diag {

/// Returns true for control characters (C0, DEL, C1), line separators and bidirectional controls.
bool ControlsTerminal(char32_t value);

/// A character as safe text for a terminal, and the width of this text in columns.
struct TerminalCell {
  std::string text;
  int width = 1;
};

/// Returns the safe text and width of `character`, the first character of `text`. Unsafe characters
/// are escaped like in SafeText().
TerminalCell SafeCell(std::string_view text, Utf8Char character);

/// Returns the text with every invalid byte replaced by U+FFFD.
std::string ValidUtf8(std::string_view text);

}  // namespace mjforge::diag
