// Matting from pictures on a light and on a black floor, with a soft shadow.

#include "mjforge/picture/matte.h"

#include <algorithm>
#include <cmath>

namespace mjforge::picture {
namespace {

// Alpha of a full shadow, which ambient light keeps from being black.
constexpr float kDarkest = 0.62F;
// Half the width of a shadow's soft edge, as a share of the picture's shorter side.
constexpr double kSoftness = 0.011;
// Shadows fade out towards the picture's border, over this share of its shorter side.
constexpr float kEdge = 0.10F;
// Brightness and alpha up to this level (of 255) are rounding errors and count as zero.
constexpr int kNothing = 2;

// Computes the moving mean over 2 * radius + 1 values; values outside count as zero. Weights are
// blurred in the same way, so that the picture's border needs no special case.
void Blur(const float* in, float* out, int count, int stride, int radius) {
  float sum = 0;
  for (int i = 0; i < std::min(radius, count); ++i) sum += in[i * stride];
  for (int i = 0; i < count; ++i) {
    if (i + radius < count) sum += in[(i + radius) * stride];
    if (i - radius - 1 >= 0) sum -= in[(i - radius - 1) * stride];
    out[i * stride] = sum / static_cast<float>(2 * radius + 1);
  }
}

// Blurs with three box filters, which approximate a Gaussian.
void BlurAll(std::vector<float>& values, int width, int height, int radius) {
  std::vector<float> other(values.size());
  for (int pass = 0; pass < 3; ++pass) {
    for (int y = 0; y < height; ++y) {
      const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(y) * width;
      Blur(values.data() + row, other.data() + row, width, 1, radius);
    }
    for (int x = 0; x < width; ++x)
      Blur(other.data() + x, values.data() + x, height, width, radius);
  }
}

std::uint8_t ToByte(float value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255));
}

}  // namespace

Matte::Matte(int width, int height, int samples)
    : width_(width), height_(height), samples_(samples) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  color_.resize(3 * pixels);
  alpha_.resize(pixels);
  floor_.resize(pixels);
  shade_.resize(pixels);
}

void Matte::Add(const RenderedBand& drawn, int top, int bottom) {
  const int columns = width_ * samples_;
  const int rows = (bottom - top) * samples_;
  const float weight = 1.0F / static_cast<float>(samples_ * samples_);
  for (int row = 0; row < rows; ++row) {
    const std::size_t start =
        static_cast<std::size_t>(rows - 1 - row) * static_cast<std::size_t>(columns) * 3;
    const std::uint8_t* light = drawn.on_light.data() + start;
    const std::uint8_t* black = drawn.on_black.data() + start;
    const std::size_t first =
        static_cast<std::size_t>(top + row / samples_) * static_cast<std::size_t>(width_);
    for (int column = 0; column < columns; ++column, light += 3, black += 3) {
      const std::size_t pixel = first + static_cast<std::size_t>(column / samples_);
      const int seen = std::clamp(light[1] - black[1], 0, drawn.light);
      const int hidden = drawn.light - seen <= kNothing ? 0 : drawn.light - seen;
      const float alpha = static_cast<float>(hidden) / static_cast<float>(drawn.light);
      if (seen > kNothing && black[0] + black[1] + black[2] == 0) {
        floor_[pixel] += weight;
        shade_[pixel] += weight * alpha;
        continue;
      }
      alpha_[pixel] += weight * alpha;
      for (std::size_t c = 0; c < 3; ++c)
        color_[3 * pixel + c] += weight * static_cast<float>(black[c]) / 255;
    }
  }
}

// Replaces the shadow on each floor pixel by the mean over the floor pixels around it. Pixels of
// the object have no weight, so that the shadow stays dark next to it.
void Matte::Soften() {
  const int radius = static_cast<int>(std::lround(kSoftness * std::min(width_, height_)));
  if (radius < 1 || std::none_of(shade_.begin(), shade_.end(), [](float s) { return s > 0; }))
    return;
  std::vector<float> weight = floor_;
  BlurAll(weight, width_, height_, radius);
  BlurAll(shade_, width_, height_, radius);
  constexpr float kLeast = 1e-4F;
  for (std::size_t i = 0; i < shade_.size(); ++i) {
    shade_[i] = weight[i] > kLeast ? floor_[i] * shade_[i] / weight[i] : 0;
  }
}

float Matte::EdgeFade(std::size_t pixel) const {
  const int x = static_cast<int>(pixel % static_cast<std::size_t>(width_));
  const int y = static_cast<int>(pixel / static_cast<std::size_t>(width_));
  const int inside = std::min({x, y, width_ - 1 - x, height_ - 1 - y});
  const float way =
      static_cast<float>(inside) / (kEdge * static_cast<float>(std::min(width_, height_)));
  const float t = std::min(way, 1.0F);
  return t * t * (3 - 2 * t);
}

Image Matte::Finish() {
  Soften();
  Image image{width_, height_, {}};
  image.rgba.resize(4 * alpha_.size());
  for (std::size_t i = 0; i < alpha_.size(); ++i) {
    const float alpha = std::min(alpha_[i] + kDarkest * EdgeFade(i) * shade_[i], 1.0F);
    if (alpha <= 0) continue;
    for (std::size_t c = 0; c < 3; ++c) image.rgba[4 * i + c] = ToByte(color_[3 * i + c] / alpha);
    image.rgba[4 * i + 3] = ToByte(alpha);
  }
  return image;
}

}  // namespace mjforge::picture
