// PNG encoder for images: RGB if the image is opaque, otherwise RGBA.

#include "mjforge/picture/picture.h"

#include <algorithm>

#include "mjforge/bytes/bytes.h"

namespace mjforge::picture {
namespace {

constexpr std::size_t kAlpha = 3;
constexpr std::size_t kChannels = 4;

bool IsOpaque(const Image& image) {
  for (std::size_t i = kAlpha; i < image.rgba.size(); i += kChannels) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

std::vector<std::uint8_t> WithoutAlpha(const Image& image) {
  std::vector<std::uint8_t> rgb(image.rgba.size() / kChannels * kAlpha);
  std::uint8_t* to = rgb.data();
  for (std::size_t i = 0; i < image.rgba.size(); i += kChannels)
    to = std::copy_n(image.rgba.data() + i, kAlpha, to);
  return rgb;
}

}  // namespace

std::string EncodePng(const Image& image, const Texts& texts) {
  const bool has_alpha = !IsOpaque(image);
  const std::vector<std::uint8_t> colors = has_alpha ? image.rgba : WithoutAlpha(image);
  return bytes::EncodePng(
      {.width = image.width, .height = image.height, .colors = colors, .has_alpha = has_alpha},
      texts, bytes::PngEffort::kFast);
}

}  // namespace mjforge::picture
