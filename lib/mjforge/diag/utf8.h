#pragma once

// Private to the room: makes text of unknown origin safe to show.

#include <cstddef>
#include <string>
#include <string_view>

namespace mjforge::diag {

/// The character at the start of a text.
struct Utf8Char {
  char32_t value = 0;
  std::size_t length = 1;  // in bytes
  bool valid = false;      // false: one byte that is not UTF-8
};

/// `text` must not be empty.
Utf8Char DecodeUtf8(std::string_view text);

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
