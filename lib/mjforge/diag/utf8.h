#pragma once

// Private to the room: makes text of unknown origin safe to show.

#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::diag {

/// What a terminal may be sent for a character, and how many columns it takes.
struct TerminalCell {
  std::string text;
  int width = 1;
};

/// As SafeText, for one character.
TerminalCell SafeCell(std::string_view text, Utf8Char character);

/// `text` with every invalid byte replaced by U+FFFD.
std::string ValidUtf8(std::string_view text);

}  // namespace mjforge::diag
