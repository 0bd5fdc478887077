#include "mjforge/picture/matte.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

namespace mjforge::picture {
namespace {

constexpr int kSamples = 2;  // along each side of a pixel

using Bytes = std::vector<std::uint8_t>;

// A picture of one color on each floor, in samples.
Image Finish(int side, std::uint8_t on_light, std::uint8_t on_black) {
  const auto samples = static_cast<std::size_t>(side * side * kSamples * kSamples * 3);
  const Bytes light(samples, on_light);
  const Bytes black(samples, on_black);
  Matte matte(side, side, kSamples);
  matte.Add(RenderedBand{light, black, 200}, 0, side);
  return matte.Finish();
}

TEST_CASE("a lit floor is nothing at all") {
  CHECK(Finish(4, 200, 0).rgba == Bytes(64, 0));
  CHECK(Finish(4, 199, 0).rgba == Bytes(64, 0));  // a rounding
  CHECK(Finish(4, 255, 0).rgba == Bytes(64, 0));  // the backdrop
}

TEST_CASE("what looks the same on both floors is opaque") {
  const Image image = Finish(2, 90, 90);
  CHECK(image.rgba[0] == 90);
  CHECK(image.rgba[3] == 255);
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
  matte.Add(OpaqueBand{colors, depths, {0.6, 0.2 / 3, 0}, 120}, 0, 1);
  const Bytes drawn = matte.Finish().rgba;
  CHECK(drawn == Bytes{120, 120, 120, 255, 120, 120, 120, 128, 0, 0, 0, 0});
}

TEST_CASE("an opaque object and its shadow are the same with depths and on two floors") {
  constexpr int kSide = 41;
  constexpr std::size_t kCount = std::size_t{kSide} * kSide * kSamples * kSamples;
  Bytes light(3 * kCount, 200);
  Bytes black(3 * kCount, 0);
  std::vector<float> depths(kCount, 0.7F);
  for (std::size_t i = 0; i < kCount; ++i) {
    const bool object = i % 7 == 0;
    if (object) depths[i] = 0.3F;
    for (std::size_t c = 0; c < 3; ++c) {
      if (object) {
        light[3 * i + c] = black[3 * i + c] = static_cast<std::uint8_t>(40 + i % 90);
      } else if (i > kCount / 2) {
        light[3 * i + c] = 100;
      }
    }
  }
  Matte once(kSide, kSide, kSamples);
  once.Add(OpaqueBand{light, depths, {0.5, 0, 0}, 200}, 0, kSide);
  Matte twice(kSide, kSide, kSamples);
  twice.Add(RenderedBand{light, black, 200}, 0, kSide);
  const Bytes expected = twice.Finish().rgba;
  const Bytes drawn = once.Finish().rgba;
  int most = 0;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    most = std::max(most, std::abs(drawn[i] - expected[i]));
  CHECK(most <= 1);
}

TEST_CASE("rows come from the bottom, bands from the top") {
  Matte matte(1, 2, kSamples);
  const Bytes dark(12, 10);
  const Bytes bright(12, 250);
  matte.Add(RenderedBand{dark, dark, 200}, 0, 1);
  matte.Add(RenderedBand{bright, bright, 200}, 1, 2);
  Bytes mixed = matte.Finish().rgba;
  CHECK(mixed == Bytes{10, 10, 10, 255, 250, 250, 250, 255});

  Matte whole(1, 2, kSamples);
  Bytes both = bright;
  both.insert(both.end(), dark.begin(), dark.end());
  whole.Add(RenderedBand{both, both, 200}, 0, 2);
  CHECK(whole.Finish().rgba == mixed);
}

}  // namespace
}  // namespace mjforge::picture
