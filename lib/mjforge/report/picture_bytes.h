#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjforge::report {

/// "aGk=", as in RFC 4648.
std::string Base64(std::string_view bytes);

struct PictureInfo {
  std::string_view type;  // "image/png", "image/webp"
  unsigned width = 0;
  unsigned height = 0;
};
/// The type and size of a PNG or WebP file; nothing for other bytes.
std::optional<PictureInfo> ReadPictureInfo(std::string_view bytes);

}  // namespace mjforge::report
