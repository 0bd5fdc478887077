#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// At most `most` colors for all pixels of some images, and which of them is nearest to a pixel's
/// color. Alpha is ignored.
class Palette {
 public:
  Palette(std::span<const Image> images, std::size_t most);

  const std::vector<Background::Color>& colors() const { return colors_; }
  std::uint8_t Nearest(const std::uint8_t* rgb) const { return nearest_[CellOf(rgb)]; }

 private:
  // Colors that agree in their first bits share a cell.
  static constexpr int kBits = 5;
  static std::size_t CellOf(const std::uint8_t* rgb) {
    constexpr int kDropped = 8 - kBits;
    return static_cast<std::size_t>((rgb[0] >> kDropped << 2 * kBits) |
                                    (rgb[1] >> kDropped << kBits) | rgb[2] >> kDropped);
  }

  std::vector<Background::Color> colors_;
  std::vector<std::uint8_t> nearest_;  // by cell
};

}  // namespace mjforge::picture
