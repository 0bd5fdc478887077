#include "mjforge/report/picture_bytes.h"

#include <catch2/catch.hpp>

namespace mjforge::report {
namespace {

using namespace std::string_literals;

TEST_CASE("base64 is that of RFC 4648") {
  CHECK(Base64("").empty());
  CHECK(Base64("f") == "Zg==");
  CHECK(Base64("fo") == "Zm8=");
  CHECK(Base64("foo") == "Zm9v");
  CHECK(Base64("foobar") == "Zm9vYmFy");
  CHECK(Base64("\xff\xfe\xfd"s) == "//79");
  CHECK(Base64("\0\0"s) == "AAA=");
}

std::string InfoText(const std::string& bytes) {
  const auto info = ReadPictureInfo(bytes);
  if (!info) return "none";
  return std::string(info->type) + " " + std::to_string(info->width) + " " +
         std::to_string(info->height);
}

TEST_CASE("a picture says its type and size") {
  CHECK(InfoText("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x01\x40\0\0\0\xf0\x08\x06\0\0\0"s) ==
        "image/png 320 240");
  CHECK(InfoText("RIFF\0\0\0\0WEBPVP8 \0\0\0\0\0\0\0\x9d\x01\x2a\x40\x01\xf0\0"s) ==
        "image/webp 320 240");
  CHECK(InfoText("RIFF\0\0\0\0WEBPVP8L\0\0\0\0\x2f\x3f\xc1\x3b\0\0\0\0\0\0"s) ==
        "image/webp 320 240");
  CHECK(InfoText("RIFF\0\0\0\0WEBPVP8X\0\0\0\0\0\0\0\0\x3f\x01\0\xef\0\0"s) ==
        "image/webp 320 240");
}

TEST_CASE("other bytes are no picture") {
  CHECK(InfoText("") == "none");
  CHECK(InfoText("<svg/>") == "none");
  CHECK(InfoText("\x89PNG\r\n\x1a\n"s) == "none");
  CHECK(InfoText("RIFF\0\0\0\0WEBP"s) == "none");
  CHECK(InfoText("RIFF\0\0\0\0WEBPVP9 \0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"s) == "none");
}

}  // namespace
}  // namespace mjforge::report
