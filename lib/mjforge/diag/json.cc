#include "mjforge/diag/json.h"

namespace mjforge::diag {

void Json::Value(std::string_view text) {
  constexpr std::string_view kEscaped = "\"\\\b\f\n\r\t";
  constexpr std::string_view kLetters = "\"\\bfnrt";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  Separate();
  text_ += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && c != '"' && c != '\\') {
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
