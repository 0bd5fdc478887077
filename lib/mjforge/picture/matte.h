// Matting: turns renderings of an object on a light floor into a picture with alpha and a soft
// shadow.
//
// The depth of a sample determines whether the sample belongs to an opaque geom, because
// translucent geoms do not change the depth. If there are translucent geoms, a second rendering has
// only these geoms, on black. The difference of the two renderings is the light of the floor that
// passes through the geoms, and gives their alpha (A. R. Smith, J. F. Blinn: Blue Screen Matting,
// SIGGRAPH 1996, section 3, with two backing colors). Samples that show only the floor become a
// shadow: black, with an alpha that is blurred.

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mjforge/picture/camera.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// MuJoCo's renderings of some rows of a picture. The arrays start with the lowest row.
struct RenderedBand {
  std::span<const std::uint8_t> colors;       // on the light floor; 3 bytes per sample
  std::span<const float> depths;              // 1: nothing opaque was drawn
  std::span<const std::uint8_t> translucent;  // translucent geoms alone; empty: there are none
  LevelDepth floor;     // depth of a plane above the floor; no opaque geom is behind this plane
  double backdrop = 1;  // depth before the backdrop; no opaque geom is behind this depth
  int light = 255;      // brightness of the floor outside of shadows, 0..255
};

/// Computes a picture with alpha and shadow from renderings of its rows.
class Matte {
 public:
  /// Makes a picture of this size, in pixels, with `samples` samples along each side of a pixel.
  Matte(int width, int height, int samples);
  /// Adds the renderings of rows [top, bottom) of the picture.
  void Add(const RenderedBand& drawn, int top, int bottom);
  /// Returns the whole picture. Call it once, after all rows were added.
  Image Finish();

 private:
  // Sums over the samples of a pixel. Each sample adds at most RenderedBand::light to `hidden` and
  // to `shade`, and at most 255 to each component of `color`.
  struct PixelSums {
    std::array<int, 3> color = {};
    int hidden = 0;  // brightness of the floor that the object hides
    int floor = 0;   // number of samples that show the floor
    int shade = 0;   // brightness that the floor samples lack because of the shadow
  };

  template <typename AddSample>
  void AddSamples(int top, int bottom, int light, const AddSample& add_sample);
  void AddPixel(std::size_t pixel, int light, const PixelSums& sums);
  void Soften();
  float EdgeFade(std::size_t pixel) const;

  int width_;
  int height_;
  int samples_;
  // Values of each pixel, 0..1: colors times alpha, alpha, the share of the samples that show the
  // floor, and the darkness of the shadow on the floor times this share.
  std::vector<float> color_;
  std::vector<float> alpha_;
  std::vector<float> floor_;
  std::vector<float> shade_;
};

}  // namespace mjforge::picture
