// Matting: two renderings on different floors give a picture with alpha and a soft shadow.
//
// An object with translucent parts is rendered twice, on a light and on a black floor. The
// difference is the visible share of the floor, lit or in shadow, and so gives the alpha of the
// object in front of it (A. R. Smith, J. F. Blinn: Blue Screen Matting, SIGGRAPH 1996, section 3,
// with two backing colors). An opaque object is rendered once, because the depth of a sample tells
// whether it belongs to the object. The floor itself becomes a shadow: black, with an alpha that is
// blurred.

#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mjforge/picture/camera.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// MuJoCo's two renderings of some rows: 3 bytes per sample, starting with the lowest row.
struct RenderedBand {
  std::span<const std::uint8_t> on_light;  // on the light floor
  std::span<const std::uint8_t> on_black;
  int light = 255;  // brightness of the light floor outside of shadows, 0..255
};

/// MuJoCo's only rendering of some rows of an opaque object, starting with the lowest row.
struct OpaqueBand {
  std::span<const std::uint8_t> colors;  // on the light floor; 3 bytes per sample
  std::span<const float> depths;         // 1: nothing was drawn
  LevelDepth floor;  // samples at this depth or deeper do not belong to the object
  int light = 255;   // see RenderedBand
};

/// Accumulates renderings, and computes the picture from them.
class Matte {
 public:
  /// A picture of this size, with this number of samples along each side of a pixel.
  Matte(int width, int height, int samples);
  /// Adds the renderings of rows [top, bottom) of the picture.
  void Add(const RenderedBand& drawn, int top, int bottom);
  void Add(const OpaqueBand& drawn, int top, int bottom);
  /// Returns the whole picture. Call it once, after all rows were added.
  Image Finish();

 private:
  // Sums over the samples of a pixel. Shares of the light are in units of 1 / light.
  struct PixelSums {
    std::array<int, 3> color = {};
    int hidden = 0;  // the light that the object hides
    int floor = 0;   // samples that show the floor
    int shade = 0;   // the light that these lack
  };

  template <typename AddSample>
  void AddSamples(int top, int bottom, int light, const AddSample& add_sample);
  void AddPixel(std::size_t pixel, int light, const PixelSums& sums);
  void Soften();
  float EdgeFade(std::size_t pixel) const;

  int width_;
  int height_;
  int samples_;
  // Values of each pixel, 0..1: colors times alpha, alpha, the visible share of the floor, and the
  // shadow on this share.
  std::vector<float> color_;
  std::vector<float> alpha_;
  std::vector<float> floor_;
  std::vector<float> shade_;
};

}  // namespace mjforge::picture
