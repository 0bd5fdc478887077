#include "mjforge/picture/text.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace mjforge::picture {
namespace {

constexpr int kWidth = 2048;  // of a line, samples
constexpr int kHeight = 64;

std::string AsAscii(std::string_view text) {
  std::string ascii(text);
  for (char& c : ascii) {
    if (c < ' ' || c > '~') c = '?';
  }
  return ascii;
}

}  // namespace

// Twice the size, for two samples along each side of a pixel.
Font::Font() : model_(engine::Engine().LoadText("<mujoco/>").model) {
  if (!model_) throw std::runtime_error("MuJoCo refuses an empty model");
  model_->vis.global.offwidth = kWidth;
  model_->vis.global.offheight = kHeight;
  model_->vis.quality.offsamples = 0;
  model_->vis.quality.shadowsize = 0;
  mjr_defaultContext(&context_);
  mjr_makeContext(model_.get(), &context_, mjFONTSCALE_200);
}

Font::~Font() { mjr_freeContext(&context_); }

Image Font::Draw(std::string_view text, const Background::Color& color) {
  const std::string ascii = AsAscii(text);
  int width = 0;
  for (const char c : ascii) width += context_.charWidth[static_cast<unsigned char>(c)];
  width = std::min(width + 8, kWidth) & ~1;
  const int height = std::min(context_.charHeight + 8, kHeight) & ~1;
  mjr_setBuffer(mjFB_OFFSCREEN, &context_);
  const mjrRect line = {0, 0, width, height};
  mjr_label(line, mjFONT_NORMAL, ascii.c_str(), 0, 0, 0, 1, 1, 1, 1, &context_);
  std::vector<unsigned char> drawn(static_cast<std::size_t>(width * height * 3));
  mjr_readPixels(drawn.data(), nullptr, line, &context_);
  Image image{width / 2, height / 2, {}};
  image.rgba.reserve(static_cast<std::size_t>(image.width * image.height * 4));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int corner = ((height - 2 - 2 * y) * width + 2 * x) * 3;
      int sum = 0;
      for (const int sample : {0, 3, 3 * width, 3 * width + 3})
        sum += drawn[static_cast<std::size_t>(corner + sample)];
      image.rgba.insert(image.rgba.end(), color.begin(), color.end());
      image.rgba.push_back(static_cast<std::uint8_t>(sum / 4));
    }
  }
  return image;
}

}  // namespace mjforge::picture
