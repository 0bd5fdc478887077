// Decoding of UTF-8, escapes of unsafe characters, and the width of characters.

#include "mjforge/diag/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "mjforge/diag/diag.h"

namespace mjforge::diag {
namespace {

struct CodePoints {
  char32_t first;
  char32_t last;
};

bool Within(char32_t value, std::span<const CodePoints> ranges) {
  return std::ranges::any_of(ranges,
                             [value](CodePoints r) { return value >= r.first && value <= r.last; });
}

// Control characters (C0, DEL, C1), line separators and bidirectional controls.
constexpr std::array kUnsafe = {CodePoints{0x00, 0x1f},     CodePoints{0x7f, 0x9f},
                                CodePoints{0x61c, 0x61c},   CodePoints{0x200e, 0x200f},
                                CodePoints{0x2028, 0x202e}, CodePoints{0x2066, 0x2069}};

// Characters of width 0: combining marks, zero-width joiners, variation selectors, byte-order mark.
constexpr std::array kNoWidth = {CodePoints{0x300, 0x36f}, CodePoints{0x200b, 0x200d},
                                 CodePoints{0x20d0, 0x20ff}, CodePoints{0xfe00, 0xfe0f},
                                 CodePoints{0xfeff, 0xfeff}};

// Blocks of characters of width 2: an approximation of Unicode's East Asian Width (UAX #11).
constexpr std::array kWide = {
    CodePoints{0x1100, 0x115f},   CodePoints{0x2e80, 0x303e},  CodePoints{0x3040, 0xa4cf},
    CodePoints{0xac00, 0xd7a3},   CodePoints{0xf900, 0xfaff},  CodePoints{0xfe30, 0xfe6f},
    CodePoints{0xff00, 0xff60},   CodePoints{0xffe0, 0xffe6},  CodePoints{0x1f300, 0x1f64f},
    CodePoints{0x1f900, 0x1f9ff}, CodePoints{0x20000, 0x3fffd}};

int Width(char32_t value) {
  if (value < 0x300) return 1;
  if (Within(value, kNoWidth)) return 0;
  return Within(value, kWide) ? 2 : 1;
}

std::string Escape(char32_t value) {
  if (value == '\n') return "\\n";
  if (value == '\r') return "\\r";
  if (value == '\t') return "\\t";
  return value < 0x80 ? fmt::format("\\x{:02x}", static_cast<unsigned>(value))
                      : fmt::format("\\u{:04x}", static_cast<unsigned>(value));
}

}  // namespace

Utf8Char DecodeUtf8(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return {};
  char32_t value = lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (!IsContinuation(text[i])) return {};
    value = (value << 6) | (byte(i) & 0x3fu);
  }
  // Rejects overlong forms, surrogates, and values beyond the last plane.
  constexpr std::array<char32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  if (value < kLeast[length] || (value >= 0xd800 && value <= 0xdfff) || value > 0x10ffff) return {};
  return {value, length, true};
}

bool ControlsTerminal(char32_t value) { return Within(value, kUnsafe); }

TerminalCell SafeCell(std::string_view text, Utf8Char character) {
  if (character.valid && !ControlsTerminal(character.value))
    return {std::string(text.substr(0, character.length)), Width(character.value)};
  std::string shown = character.valid
                          ? Escape(character.value)
                          : fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
  const int width = static_cast<int>(shown.size());
  return {std::move(shown), width};
}

std::string SafeText(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Utf8Char character = DecodeUtf8(text);
    out += SafeCell(text, character).text;
    text.remove_prefix(character.length);
  }
  return out;
}

std::string SafeLines(std::string_view text) {
  std::string out;
  while (true) {
    const std::size_t end = text.find('\n');
    out += SafeText(text.substr(0, end));
    if (end == std::string_view::npos) return out;
    out += '\n';
    text.remove_prefix(end + 1);
  }
}

std::string ValidUtf8(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Utf8Char character = DecodeUtf8(text);
    out += character.valid ? text.substr(0, character.length) : "\xef\xbf\xbd";
    text.remove_prefix(character.length);
  }
  return out;
}

}  // namespace mjforge::diag
