// Images, and their encoding as PNG, GIF and WebP.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace mjforge::picture {

/// An image of four bytes per pixel (red, green, blue, alpha), starting with the top row. Colors
/// are not premultiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Keys and values of the text comments in a picture's file.
using Texts = std::vector<std::pair<std::string, std::string>>;
std::string EncodePng(const Image& image, const Texts& texts);
/// Encodes images as an endless GIF animation in 255 colors, whose pixels are either opaque or
/// transparent. Each frame is shown for `delay` ms, rounded down to a multiple of 10 ms.
std::string EncodeGif(std::span<const Image> frames, int delay, const Texts& texts);
/// Encodes an image as lossy WebP; `quality` is from 0 to 100.
std::string EncodeWebp(const Image& image, int quality);
/// Encodes an image like EncodeWebp, but five times as fast and to a file that is a third larger.
std::string EncodeWebpFast(const Image& image, int quality);
/// Encodes opaque images of one size as an endless, lossy WebP animation. Each image is shown for
/// `delay` ms; equal consecutive images become one frame.
std::string EncodeWebpFilm(std::span<const Image> frames, int delay, int quality);

}  // namespace mjforge::picture
