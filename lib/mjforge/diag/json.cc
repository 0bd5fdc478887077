// Escaping of texts in JSON, and the check of the nesting depth.

#include "mjforge/diag/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "mjforge/diag/utf8.h"

namespace mjforge::diag {

bool IsNestedTooDeep(std::string_view json) {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') {
      in_text = !in_text;
    } else if (in_text) {
      if (c == '\\') ++i;
    } else if (c == '[' || c == '{') {
      if (++depth > kMaxJsonDepth) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

namespace {

// Flags by byte value: true if the byte must be escaped in JSON, is DEL, or is the first byte of a
// UTF-8 character that may control a terminal (0xc2, 0xd8, 0xe2). A table makes the test of every
// byte of a text fast.
constexpr auto kMayNeedEscape = [] {
  std::array<bool, 256> needs{};
  for (std::size_t c = 0; c < 0x20; ++c) needs[c] = true;
  for (const std::size_t c : {0x22, 0x5c, 0x7f, 0xc2, 0xd8, 0xe2}) needs[c] = true;
  return needs;
}();

bool MayNeedEscape(char c) { return kMayNeedEscape[static_cast<unsigned char>(c)]; }

}  // namespace

void Json::Value(std::string_view text) {
  Separate();
  if (std::ranges::any_of(text, MayNeedEscape)) return Escaped(text);
  const std::size_t start = text_.size();
  text_.resize(start + text.size() + 2, '"');
  text.copy(&text_[start + 1], text.size());
}

void Json::Escaped(std::string_view text) {
  constexpr std::string_view kEscaped = "\"\\\b\f\n\r\t";
  constexpr std::string_view kLetters = "\"\\bfnrt";
  text_ += '"';
  while (!text.empty()) {
    const Utf8Char character = DecodeUtf8(text);
    const std::size_t at = kEscaped.find(text[0]);
    if (at != kEscaped.npos) {
      text_ += {'\\', kLetters[at]};
    } else if (character.valid && ControlsTerminal(character.value)) {
      text_ += fmt::format("\\u{:04X}", static_cast<unsigned>(character.value));
    } else {
      text_ += text.substr(0, character.length);
    }
    text.remove_prefix(character.length);
  }
  text_ += '"';
}

}  // namespace mjforge::diag
