// Recognition of binary file formats by their signatures.

#include <cstddef>
#include <string_view>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {

std::string_view KindOf(std::string_view text) {
  struct Signature {
    std::size_t at;
    std::string_view bytes;
    std::string_view kind;
  };
  using namespace std::string_view_literals;
  constexpr Signature kSignatures[] = {
      {257, "ustar"sv, "a tar archive"},       {0, "\x28\xb5\x2f\xfd"sv, "an archive (Zstandard)"},
      {0, "\x1f\x8b"sv, "compressed (gzip)"},  {0, "PK\x03\x04"sv, "a ZIP archive"},
      {0, "\x89PNG\r\n"sv, "a picture (PNG)"}, {0, "\xff\xd8\xff"sv, "a picture (JPEG)"},
      {0, "GIF8"sv, "a picture (GIF)"},        {0, "\177ELF"sv, "a program"},
      {0, "%PDF-"sv, "a PDF document"}};
  for (const auto& [at, bytes, kind] : kSignatures) {
    if (text.size() > at && text.substr(at).starts_with(bytes)) return kind;
  }
  return {};
}

}  // namespace mjforge::bytes
