#include "mjforge/diag/json.h"

#include <algorithm>

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

bool NeedsEscape(char c) { return static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\'; }

}  // namespace

void Json::Value(std::string_view text) {
  constexpr std::string_view kEscaped = "\"\\\b\f\n\r\t";
  constexpr std::string_view kLetters = "\"\\bfnrt";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  Separate();
  text_ += '"';
  // Up to the next one to escape.
  for (auto from = text.begin(); from != text.end();) {
    const auto found = std::find_if(from, text.end(), NeedsEscape);
    text_.append(from, found);
    from = found;
    if (from == text.end()) break;
    const char c = *from++;
    const auto byte = static_cast<unsigned char>(c);
    if (const std::size_t at = kEscaped.find(c); at != kEscaped.npos) {
      text_ += {'\\', kLetters[at]};
    } else {
      text_ += {'\\', 'u', '0', '0', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  text_ += '"';
}

}  // namespace mjforge::diag
