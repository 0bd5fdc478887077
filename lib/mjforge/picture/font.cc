// Drawing of text: MuJoCo draws a line of text in a large font, which is then scaled down.

#include "mjforge/picture/font.h"

#include <algorithm>
#include <string>

namespace mjforge::picture {
namespace {

constexpr std::size_t Index(int i) { return static_cast<std::size_t>(i); }

constexpr int kFine = 3;      // samples along each side of a pixel
constexpr int kWidth = 3072;  // width of the buffer, samples
constexpr int kHeight = 64;

std::string ToAscii(std::string_view text) {
  std::string ascii(text);
  std::ranges::replace_if(
      ascii, [](char c) { return c < ' ' || c > '~'; }, '?');
  return ascii;
}

}  // namespace

// Uses MuJoCo's largest font size, which has the smoothest shapes; Draw scales the text down.
Font::Font() : context_(MakeBuffers(kWidth, kHeight, 0, mjFONTSCALE_300)) {}

Image Font::Draw(std::string_view text, const Background::Color& color) {
  const std::string ascii = ToAscii(text);
  int width = 0;
  for (const char c : ascii) width += context_->charWidth[static_cast<unsigned char>(c)];
  width = std::min(width + 4 * kFine, kWidth) / kFine * kFine;
  const int height = std::min(context_->charHeight + kFine, kHeight) / kFine * kFine;
  mjr_setBuffer(mjFB_OFFSCREEN, context_.get());
  const mjrRect line = {0, 0, width, height};
  mjr_label(line, mjFONT_NORMAL, ascii.c_str(), 0, 0, 0, 1, 1, 1, 1, context_.get());
  std::vector<unsigned char> drawn(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height) * 3);
  mjr_readPixels(drawn.data(), nullptr, line, context_.get());
  Image image{width / kFine, height / kFine, {}};
  image.rgba.reserve(Index(image.width) * Index(image.height) * 4);
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      int sum = 0;
      for (int row = kFine * y; row < kFine * (y + 1); ++row) {
        for (int column = kFine * x; column < kFine * (x + 1); ++column)
          sum += drawn[3 * (Index(row) * Index(width) + Index(column))];
      }
      image.rgba.insert(image.rgba.end(), color.begin(), color.end());
      image.rgba.push_back(static_cast<std::uint8_t>(sum / (kFine * kFine)));
    }
  }
  return image;
}

}  // namespace mjforge::picture
