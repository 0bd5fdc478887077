#pragma once

// From what MuJoCo draws to a picture without a background.
//
// Every picture is drawn twice, on a light and on a black floor. The difference shows how much of
// the floor is seen, in light or in shadow, and so gives the alpha of what stands on it (as in A.
// R. Smith, J. F. Blinn: Blue Screen Matting, SIGGRAPH 1996, section 3, with two backing colors).
// The floor itself becomes a shadow, black with an alpha, which is made soft.

#include <cstdint>
#include <span>
#include <vector>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// Samples along each side of a pixel.
inline constexpr int kSamples = 2;

/// What MuJoCo drew: rows from the bottom, 3 bytes per sample.
struct Drawn {
  std::span<const std::uint8_t> on_light;  // floor
  std::span<const std::uint8_t> on_black;
  int light = 255;  // of the lit floor, 0..255
};

class Matte {
 public:
  Matte(int width, int height);
  /// Rows [top, bottom) of the picture.
  void Add(const Drawn& drawn, int top, int bottom);
  /// The whole picture.
  Image Finish();

 private:
  void Soften();
  float EdgeFade(std::size_t pixel) const;

  int width_;
  int height_;
  // Of each pixel, 0..1: colors times alpha, alpha, the share that is floor, and
  // the shadow on that share.
  std::vector<float> color_;
  std::vector<float> alpha_;
  std::vector<float> floor_;
  std::vector<float> shade_;
};

}  // namespace mjforge::picture
