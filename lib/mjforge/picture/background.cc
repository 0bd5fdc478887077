#include <algorithm>
#include <array>
#include <charconv>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

constexpr std::array<std::string_view, 5> kLayers = {"visual", "collision", "bounds", "inertia",
                                                     "joints"};

Background Plain(Background::Color color) { return {color, color, false}; }

}  // namespace

std::span<const std::string_view> LayerNames() { return kLayers; }

std::optional<Layer> ParseLayer(std::string_view name) {
  const auto* found = std::find(kLayers.begin(), kLayers.end(), name);
  if (found == kLayers.end()) return std::nullopt;
  return static_cast<Layer>(found - kLayers.begin());
}

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

void PutOn(const Background& background, Image& image) {
  if (background.transparent) return;
  std::size_t at = 0;
  for (int y = 0; y < image.height; ++y) {
    // In 1/256 steps of the way down.
    const int down = image.height > 1 ? 256 * y / (image.height - 1) : 0;
    std::array<int, 3> behind = {};
    for (std::size_t c = 0; c < 3; ++c) {
      behind[c] = (background.top[c] * (256 - down) + background.bottom[c] * down + 128) / 256;
    }
    for (int x = 0; x < image.width; ++x, at += 4) {
      const int alpha = image.rgba[at + 3];
      for (std::size_t c = 0; c < 3; ++c) {
        const int mixed = image.rgba[at + c] * alpha + behind[c] * (255 - alpha);
        image.rgba[at + c] = static_cast<std::uint8_t>((mixed + 127) / 255);
      }
      image.rgba[at + 3] = 255;
    }
  }
}

}  // namespace mjforge::picture
