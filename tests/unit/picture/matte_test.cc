#include "mjforge/picture/matte.h"

#include <catch2/catch.hpp>

namespace mjforge::picture {
namespace {

using Bytes = std::vector<std::uint8_t>;

// A picture of one color on each floor, in samples.
Image Finish(int side, std::uint8_t on_light, std::uint8_t on_black) {
  const auto samples = static_cast<std::size_t>(side * side * kSamples * kSamples * 3);
  const Bytes light(samples, on_light);
  const Bytes black(samples, on_black);
  Matte matte(side, side);
  matte.Add({light, black, 200}, 0, side);
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

TEST_CASE("rows come from the bottom, bands from the top") {
  Matte matte(1, 2);
  const Bytes dark(12, 10);
  const Bytes bright(12, 250);
  matte.Add({dark, dark, 200}, 0, 1);
  matte.Add({bright, bright, 200}, 1, 2);
  Bytes mixed = matte.Finish().rgba;
  CHECK(mixed == Bytes{10, 10, 10, 255, 250, 250, 250, 255});

  Matte whole(1, 2);
  Bytes both = bright;
  both.insert(both.end(), dark.begin(), dark.end());
  whole.Add({both, both, 200}, 0, 2);
  CHECK(whole.Finish().rgba == mixed);
}

}  // namespace
}  // namespace mjforge::picture
