// Implementation of the matting: sums over the samples of each pixel, blurring of the shadow, and
// the final image.

#include "mjforge/picture/matte.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mjforge::picture {
namespace {

// Alpha of a full shadow, which ambient light keeps from being black.
constexpr float kDarkest = 0.62F;
// Half the width of a shadow's soft edge, as a share of the picture's shorter side.
constexpr double kSoftness = 0.011;
// Shadows fade out towards the picture's border, over this share of its shorter side.
constexpr float kEdge = 0.05F;
// Hidden and missing brightness up to this level (of 255) is a rounding error and counts as zero.
constexpr int kNothing = 2;

// Computes the moving mean over 2 * radius + 1 rows, each of `width` values; rows outside count as
// zero. The border of the picture needs no special case, because Soften() divides by weights that
// are blurred in the same way.
void BlurRows(std::span<const float> in, int width, int radius, std::span<float> out) {
  const auto columns = static_cast<std::ptrdiff_t>(width);
  const std::ptrdiff_t rows = std::ssize(in) / columns;
  std::vector<float> sums(static_cast<std::size_t>(columns));
  const auto add = [&](std::ptrdiff_t row, float sign) {
    if (row < 0 || row >= rows) return;
    const float* values = in.data() + row * columns;
    for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += sign * values[x];
  };
  for (std::ptrdiff_t row = 0; row < radius; ++row) add(row, 1);
  const float share = 1 / static_cast<float>(2 * radius + 1);
  for (std::ptrdiff_t row = 0; row < rows; ++row) {
    add(row + radius, 1);
    add(row - radius - 1, -1);
    float* means = out.data() + row * columns;
    for (std::size_t x = 0; x < sums.size(); ++x) means[x] = share * sums[x];
  }
}

void Transpose(std::span<const float> in, int width, std::span<float> out) {
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t rows = in.size() / columns;
  for (std::size_t x = 0; x < columns; ++x) {
    for (std::size_t y = 0; y < rows; ++y) out[x * rows + y] = in[y * columns + x];
  }
}

// Blurs with three box filters, which approximate a Gaussian.
void BlurAll(std::vector<float>& values, int width, int height, int radius) {
  std::vector<float> other(values.size());
  const auto blur_thrice = [&](int columns) {
    BlurRows(values, columns, radius, other);
    BlurRows(other, columns, radius, values);
    BlurRows(values, columns, radius, other);
  };
  blur_thrice(width);
  Transpose(other, width, values);
  blur_thrice(height);
  Transpose(other, height, values);
}

// Rounds by adding a half before the cast, because std::lround takes several times as long.
std::uint8_t ToByte(float value) {
  constexpr float kHalf = 0.5F;
  return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255 + kHalf);
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

// Adds the samples of the rows [top, bottom) of the picture. Calls `add_sample` with the index of
// the sample in the rendering, its column and row in the picture (in samples), and the sums of its
// pixel.
template <typename AddSample>
void Matte::AddSamples(int top, int bottom, int light, const AddSample& add_sample) {
  const auto columns = static_cast<std::size_t>(width_) * static_cast<std::size_t>(samples_);
  std::size_t pixel = static_cast<std::size_t>(top) * static_cast<std::size_t>(width_);
  for (int y = top; y < bottom; ++y) {
    for (int x = 0; x < width_; ++x) {
      PixelSums sums;
      for (int row = y * samples_; row < (y + 1) * samples_; ++row) {
        // MuJoCo's renderings start with the lowest row.
        const std::size_t first = static_cast<std::size_t>(bottom * samples_ - 1 - row) * columns;
        for (int column = x * samples_; column < (x + 1) * samples_; ++column)
          add_sample(first + static_cast<std::size_t>(column), column, row, sums);
      }
      AddPixel(pixel++, light, sums);
    }
  }
}

void Matte::AddPixel(std::size_t pixel, int light, const PixelSums& sums) {
  const float weight = 1.0F / static_cast<float>(samples_ * samples_);
  const float darkness = weight / static_cast<float>(light);
  for (std::size_t c = 0; c < 3; ++c)
    color_[3 * pixel + c] += weight / 255 * static_cast<float>(sums.color[c]);
  alpha_[pixel] += darkness * static_cast<float>(sums.hidden);
  floor_[pixel] += weight * static_cast<float>(sums.floor);
  shade_[pixel] += darkness * static_cast<float>(sums.shade);
}

void Matte::Add(const RenderedBand& drawn, int top, int bottom) {
  const double per_column = drawn.floor.per_x / samples_;
  const double per_row = drawn.floor.per_y / samples_;
  const double at_corner = drawn.floor.at_corner + (per_column + per_row) / 2;
  const bool is_opaque = drawn.translucent.empty();
  AddSamples(top, bottom, drawn.light, [&](std::size_t i, int column, int row, PixelSums& sums) {
    const auto depth = static_cast<double>(drawn.depths[i]);
    const std::uint8_t* color = drawn.colors.data() + 3 * i;
    if (depth < std::min(at_corner + per_column * column + per_row * row, drawn.backdrop)) {
      sums.hidden += drawn.light;
      for (std::size_t c = 0; c < 3; ++c) sums.color[c] += color[c];
      return;
    }
    const std::uint8_t* own = is_opaque ? nullptr : drawn.translucent.data() + 3 * i;
    if (own != nullptr && own[0] + own[1] + own[2] > 0) {
      const int hidden = std::min(drawn.light - (color[1] - own[1]), drawn.light);
      if (hidden > kNothing) sums.hidden += hidden;
      for (std::size_t c = 0; c < 3; ++c) sums.color[c] += own[c];
      return;
    }
    ++sums.floor;
    const int dark = depth < 1 ? drawn.light - color[1] : 0;
    if (dark > kNothing) sums.shade += dark;
  });
}

// Replaces the shadow on each floor pixel by the mean over the floor pixels around it. Pixels of
// the object have no weight, because the shadow must stay dark next to the object.
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
    const float shadow = shade_[i] > 0 ? kDarkest * EdgeFade(i) * shade_[i] : 0;
    const float alpha = std::min(alpha_[i] + shadow, 1.0F);
    if (alpha <= 0) continue;
    for (std::size_t c = 0; c < 3; ++c) image.rgba[4 * i + c] = ToByte(color_[3 * i + c] / alpha);
    image.rgba[4 * i + 3] = ToByte(alpha);
  }
  return image;
}

}  // namespace mjforge::picture
