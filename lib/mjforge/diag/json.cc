// Escaping of JSON texts, and the check of nesting depth.

#include "mjforge/diag/json.h"

#include <algorithm>
#include <array>
#include <cstddef>

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

// Table by byte, because every character of every text is looked up.
constexpr auto kNeedsEscape = [] {
  std::array<bool, 256> needs{};
  for (std::size_t c = 0; c < 0x20; ++c) needs[c] = true;
  needs['"'] = needs['\\'] = true;
  return needs;
}();

bool NeedsEscape(char c) { return kNeedsEscape[static_cast<unsigned char>(c)]; }

}  // namespace

void Json::Value(std::string_view text) {
  Separate();
  if (std::ranges::any_of(text, NeedsEscape)) return Escaped(text);
  const std::size_t start = text_.size();
  text_.resize(start + text.size() + 2, '"');
  text.copy(&text_[start + 1], text.size());
}

void Json::Escaped(std::string_view text) {
  constexpr std::string_view kEscaped = "\"\\\b\f\n\r\t";
  constexpr std::string_view kLetters = "\"\\bfnrt";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  text_ += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (!NeedsEscape(c)) {
      text_ += c;
    } else if (const std::size_t at = kEscaped.find(c); at != kEscaped.npos) {
      text_ += {'\\', kLetters[at]};
    } else {
      text_ += {'\\', 'u', '0', '0', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  text_ += '"';
}

}  // namespace mjforge::diag
