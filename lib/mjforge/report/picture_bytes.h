#ifndef MJFORGE_REPORT_PICTURE_BYTES_H_
#define MJFORGE_REPORT_PICTURE_BYTES_H_

#include <optional>
#include <string>
#include <string_view>

namespace mjforge::report {

/// "aGk=", as RFC 4648 has it.
std::string Base64(std::string_view bytes);

struct PictureInfo {
  std::string_view type;  // "image/png", "image/webp"
  unsigned width = 0;
  unsigned height = 0;
};
/// What the bytes of a PNG or WebP file say of themselves; nothing for other bytes.
std::optional<PictureInfo> ReadPictureInfo(std::string_view bytes);

}  // namespace mjforge::report

#endif  // MJFORGE_REPORT_PICTURE_BYTES_H_
