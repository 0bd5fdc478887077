#include "mjforge/picture/matte.h"

#include <catch2/catch.hpp>
#include <span>
#include <vector>

namespace mjforge::picture {
namespace {

constexpr int kSamples = 2;  // along each side of a pixel

using Bytes = std::vector<std::uint8_t>;

constexpr LevelDepth kFloor = {0.5, 0, 0};
constexpr float kBehind = 0.7F;  // depth of the floor
constexpr float kBefore = 0.3F;  // depth of the object

// A picture of one color, of translucent geoms with another color on black, or of an object.
Image Finish(int side, std::uint8_t color, std::uint8_t own, float depth = kBehind) {
  const auto samples = static_cast<std::size_t>(side * side * kSamples * kSamples);
  const Bytes colors(3 * samples, color);
  const Bytes translucent(3 * samples, own);
  const std::vector<float> depths(samples, depth);
  Matte matte(side, side, kSamples);
  matte.Add({colors, depths, translucent, kFloor, 1, 200}, 0, side);
  return matte.Finish();
}

TEST_CASE("a lit floor is nothing at all") {
  CHECK(Finish(4, 200, 0).rgba == Bytes(64, 0));
  CHECK(Finish(4, 199, 0).rgba == Bytes(64, 0));  // a rounding
  CHECK(Finish(4, 255, 0).rgba == Bytes(64, 0));  // the backdrop
}

TEST_CASE("what looks the same on the floor and on black is opaque") {
  const Image image = Finish(2, 90, 90);
  CHECK(image.rgba[0] == 90);
  CHECK(image.rgba[3] == 255);
}

TEST_CASE("an object has its color, also behind translucent geoms") {
  CHECK(Finish(2, 90, 0, kBefore).rgba == Finish(2, 90, 90).rgba);
  CHECK(Finish(2, 90, 60, kBefore).rgba == Finish(2, 90, 90).rgba);
}

TEST_CASE("samples at the depth of the backdrop do not belong to an object") {
  const Bytes colors(12, 255);
  const std::vector<float> depths(4, 0.8F);
  Matte matte(1, 1, kSamples);
  matte.Add({colors, depths, Bytes(12, 0), {}, 0.75, 255}, 0, 1);
  CHECK(matte.Finish().rgba == Bytes(4, 0));
}

TEST_CASE("what lets half of the floor through is half opaque, in its own color") {
  const Image image = Finish(2, 160, 60);
  CHECK(image.rgba[3] == 128);
  CHECK(image.rgba[0] == 120);
}

TEST_CASE("a floor in shadow is black with an alpha, but not where the picture ends") {
  constexpr int kSide = 41;
  const Image image = Finish(kSide, 100, 0);
  const std::size_t middle = 4 * (20 * kSide + 20);
  CHECK(image.rgba[middle] == 0);
  CHECK(image.rgba[middle + 3] > 60);
  CHECK(image.rgba[middle + 3] < 128);
  CHECK(image.rgba[3] == 0);
}

TEST_CASE("the samples of an opaque object are those in front of the floor") {
  constexpr int kWidth = 3;
  constexpr std::size_t kCount = kWidth * kSamples * kSamples;
  Bytes colors(3 * kCount, 120);
  std::vector<float> depths(kCount, 0.5F);
  for (std::size_t i = 0; i < kCount; ++i) {
    // Columns of samples: the object, half of it, and nothing.
    const std::size_t column = i % (kWidth * kSamples);
    if (column > 2) depths[i] = 0.9F;
    if (column > 3) depths[i] = 1;
  }
  Matte matte(kWidth, 1, kSamples);
  // A floor that is nearer at the left: 0.8 to 0.6.
  matte.Add({colors, depths, {}, {0.6, 0.2 / 3, 0}, 1, 120}, 0, 1);
  const Bytes drawn = matte.Finish().rgba;
  CHECK(drawn == Bytes{120, 120, 120, 255, 120, 120, 120, 128, 0, 0, 0, 0});
}

TEST_CASE("rows come from the bottom, bands from the top") {
  Matte matte(1, 2, kSamples);
  const Bytes dark(12, 10);
  const Bytes bright(12, 250);
  const std::vector<float> depths(8, kBefore);
  const std::span<const float> half(depths.data(), 4);
  matte.Add({dark, half, {}, kFloor, 1, 200}, 0, 1);
  matte.Add({bright, half, {}, kFloor, 1, 200}, 1, 2);
  Bytes mixed = matte.Finish().rgba;
  CHECK(mixed == Bytes{10, 10, 10, 255, 250, 250, 250, 255});

  Matte whole(1, 2, kSamples);
  Bytes both = bright;
  both.insert(both.end(), dark.begin(), dark.end());
  whole.Add({both, depths, {}, kFloor, 1, 200}, 0, 2);
  CHECK(whole.Finish().rgba == mixed);
}

}  // namespace
}  // namespace mjforge::picture
