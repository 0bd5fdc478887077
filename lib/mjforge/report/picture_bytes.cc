#include "mjforge/report/picture_bytes.h"

#include <cstddef>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

namespace mjforge::report {
namespace {

unsigned Byte(std::string_view bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes[at]);
}

unsigned BigEndian(std::string_view bytes, std::size_t at) {
  return Byte(bytes, at) << 24 | Byte(bytes, at + 1) << 16 | Byte(bytes, at + 2) << 8 |
         Byte(bytes, at + 3);
}

unsigned LittleEndian(std::string_view bytes, std::size_t at, std::size_t count) {
  unsigned value = 0;
  for (std::size_t i = count; i > 0; --i) value = value << 8 | Byte(bytes, at + i - 1);
  return value;
}

// Google's "WebP Container Specification", and RFC 6386 (9.1) for the lossy form.
std::optional<PictureInfo> ReadWebp(std::string_view bytes) {
  if (bytes.size() < 30) return std::nullopt;
  const std::string_view form = bytes.substr(12, 4);
  PictureInfo info{"image/webp", 0, 0};
  if (form == "VP8 ") {
    info.width = LittleEndian(bytes, 26, 2) & 0x3fff;
    info.height = LittleEndian(bytes, 28, 2) & 0x3fff;
  } else if (form == "VP8L") {
    const unsigned bits = LittleEndian(bytes, 21, 4);
    info.width = (bits & 0x3fff) + 1;
    info.height = (bits >> 14 & 0x3fff) + 1;
  } else if (form == "VP8X") {
    info.width = LittleEndian(bytes, 24, 3) + 1;
    info.height = LittleEndian(bytes, 27, 3) + 1;
  } else {
    return std::nullopt;
  }
  return info;
}

}  // namespace

std::string Base64(std::string_view bytes) {
  namespace iterators = boost::archive::iterators;
  using Digits = iterators::base64_from_binary<iterators::transform_width<const char*, 6, 8>>;
  std::string text(Digits(bytes.data()), Digits(bytes.data() + bytes.size()));
  text.append((3 - bytes.size() % 3) % 3, '=');
  return text;
}

std::optional<PictureInfo> ReadPictureInfo(std::string_view bytes) {
  constexpr std::string_view kPng = "\x89PNG\r\n\x1a\n";
  if (bytes.starts_with(kPng) && bytes.size() >= 24)
    return PictureInfo{"image/png", BigEndian(bytes, 16), BigEndian(bytes, 20)};
  if (bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP")
    return ReadWebp(bytes);
  return std::nullopt;
}

}  // namespace mjforge::report
