// Backgrounds of pictures: their names, and the composition of an image with its background.

#include <array>
#include <charconv>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

Background Plain(Background::Color color) { return {color, color, false}; }

}  // namespace

std::optional<Background> ParseBackground(std::string_view text) {
  if (text == "studio") return Background();
  if (text == "transparent") return Background{.transparent = true};
  if (text == "white") return Plain({255, 255, 255});
  if (text == "black") return Plain({0, 0, 0});
  if (text == "gray") return Plain({128, 128, 128});
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  Background::Color color = {};
  for (std::size_t i = 0; i < color.size(); ++i) {
    const char* digits = text.data() + 1 + 2 * i;
    const auto [end, error] = std::from_chars(digits, digits + 2, color[i], 16);
    if (error != std::errc() || end != digits + 2) return std::nullopt;
  }
  return Plain(color);
}

void PutBehind(const Background& background, Image& image) {
  if (background.transparent) return;
  std::size_t at = 0;
  for (int y = 0; y < image.height; ++y) {
    // Vertical position of the row, from 0 (top) to 256 (bottom).
    const int down = image.height > 1 ? 256 * y / (image.height - 1) : 0;
    std::array<int, 3> behind = {};
    for (std::size_t c = 0; c < 3; ++c) {
      behind[c] = (background.top[c] * (256 - down) + background.bottom[c] * down + 128) / 256;
    }
    for (int x = 0; x < image.width; ++x, at += 4) {
      const int alpha = image.rgba[at + 3];
      if (alpha == 255) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const int mixed = image.rgba[at + c] * alpha + behind[c] * (255 - alpha);
        image.rgba[at + c] = static_cast<std::uint8_t>((mixed + 127) / 255);
      }
      image.rgba[at + 3] = 255;
    }
  }
}

}  // namespace mjforge::picture
