#pragma once

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// Returns an image in which all pixels have the color `color` (red, green, blue, alpha).
inline Image Flat(int width, int height, std::array<std::uint8_t, 4> color) {
  Image image{width, height, {}};
  image.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = color[i % 4];
  return image;
}

}  // namespace mjforge::picture
