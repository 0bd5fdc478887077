#include <gif_lib.h>
#include <webp/decode.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "harness/png.h"
#include "images.h"

namespace mjforge::picture {
namespace {

using harness::DecodePng;
using harness::PngChunks;

TEST_CASE("a PNG has the pixels of the image") {
  Image image = Flat(3, 2, {10, 20, 30, 255});
  image.rgba[4] = 200;
  image.rgba[3] = 7;
  const harness::Png png = DecodePng(EncodePng(image, {}));
  CHECK(png.width == 3);
  CHECK(png.height == 2);
  CHECK(png.rgba == image.rgba);
}

TEST_CASE("an opaque PNG has no alpha, and the same pixels") {
  const Image image = Flat(5, 4, {1, 2, 3, 255});
  const std::string bytes = EncodePng(image, {});
  CHECK(bytes[25] == 2);  // the color type: RGB
  CHECK(DecodePng(bytes).rgba == image.rgba);
}

TEST_CASE("a PNG's texts stand before its pixels") {
  const std::string bytes = EncodePng(Flat(1, 1, {0, 0, 0, 0}), {{"Software", "x 1"}, {"a", "b"}});
  CHECK(harness::PngText(bytes, "Software") == "x 1");
  CHECK(harness::PngText(bytes, "a") == "b");
  const auto chunks = PngChunks(bytes);
  REQUIRE(chunks.size() == 5);
  CHECK(chunks[1] == "tEXt 12");
  CHECK(chunks[3].starts_with("IDAT"));
}

// A decoded GIF.
struct Gif {
  explicit Gif(const std::string& bytes) : rest(bytes) {
    int error = 0;
    file = DGifOpen(this, Read, &error);
    REQUIRE(file != nullptr);
    REQUIRE(DGifSlurp(file) == GIF_OK);
  }
  ~Gif() {
    int ignored = 0;
    DGifCloseFile(file, &ignored);
  }
  static int Read(GifFileType* gif, GifByteType* out, int count) {
    std::string_view& rest = static_cast<Gif*>(gif->UserData)->rest;
    const std::size_t size = std::min(rest.size(), static_cast<std::size_t>(count));
    std::memcpy(out, rest.data(), size);
    rest.remove_prefix(size);
    return static_cast<int>(size);
  }
  GifColorType At(int frame, int pixel) const {
    return file->SColorMap->Colors[file->SavedImages[frame].RasterBits[pixel]];
  }
  std::string_view rest;
  GifFileType* file = nullptr;
};

TEST_CASE("a GIF has the frames, their colors and delays") {
  std::vector<Image> frames = {Flat(4, 4, {255, 0, 0, 255}), Flat(4, 4, {0, 0, 250, 255})};
  frames[1].rgba[3] = 0;
  const std::string bytes = EncodeGif(frames, 50, {{"Software", "x 1"}});
  CHECK(bytes.find("Software: x 1") != std::string::npos);
  const Gif gif(bytes);
  REQUIRE(gif.file->ImageCount == 2);
  CHECK(gif.At(0, 5).Red == 255);
  CHECK(gif.At(1, 5).Blue == 250);
  GraphicsControlBlock control;
  REQUIRE(DGifSavedExtensionToGCB(gif.file, 1, &control) == GIF_OK);
  CHECK(control.DelayTime == 5);
  CHECK(gif.file->SavedImages[1].RasterBits[0] == control.TransparentColor);
}

TEST_CASE("an opaque GIF stores only the pixels that change") {
  std::vector<Image> frames(2, Flat(4, 4, {250, 0, 0, 255}));
  frames[1].rgba[4 * 5] = 200;
  const Gif gif(EncodeGif(frames, 50, {}));
  GraphicsControlBlock control;
  REQUIRE(DGifSavedExtensionToGCB(gif.file, 1, &control) == GIF_OK);
  CHECK(control.DisposalMode == DISPOSE_DO_NOT);
  CHECK(gif.At(1, 5).Red == 200);
  const auto* pixels = gif.file->SavedImages[1].RasterBits;
  CHECK(std::count(pixels, pixels + 16, control.TransparentColor) == 15);
}

TEST_CASE("a GIF of many colors is near to them") {
  Image image{64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i)
    for (const int value : {4 * (i % 64), 4 * (i / 64), 128, 255})
      image.rgba.push_back(static_cast<std::uint8_t>(value));
  const Gif gif(EncodeGif({&image, 1}, 10, {}));
  double error = 0;
  for (int i = 0; i < 64 * 64; ++i)
    error += std::abs(gif.At(0, i).Red - image.rgba[static_cast<std::size_t>(4 * i)]);
  CHECK(error / (64 * 64) < 5);
}

TEST_CASE("a WebP has the image's size and nearly its colors") {
  const Image image = Flat(20, 10, {200, 100, 50, 255});
  const std::string bytes = GENERATE_COPY(EncodeWebp(image, 80), EncodeWebpFast(image, 80));
  int width = 0;
  int height = 0;
  std::uint8_t* pixels = WebPDecodeRGBA(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                        bytes.size(), &width, &height);
  REQUIRE(pixels != nullptr);
  CHECK(width == 20);
  CHECK(height == 10);
  CHECK(std::abs(pixels[0] - 200) < 6);
  CHECK(std::abs(pixels[2] - 50) < 6);
  WebPFree(pixels);
}

TEST_CASE("a WebP film has frames of the images' size, each a picture of its own") {
  const std::vector<Image> frames = {Flat(20, 10, {200, 100, 50, 255}),
                                     Flat(20, 10, {20, 30, 220, 255})};
  const std::string film = EncodeWebpFilm(frames, 70, 80);
  WebPBitstreamFeatures features;
  REQUIRE(WebPGetFeatures(reinterpret_cast<const std::uint8_t*>(film.data()), film.size(),
                          &features) == VP8_STATUS_OK);
  CHECK(features.has_animation == 1);
  CHECK(features.width == 20);
  CHECK(features.height == 10);
  std::size_t at = 0;
  for (const int blue : {50, 220}) {
    at = film.find("ANMF", at) + 8;
    CHECK(film.substr(at + 12, 3) == std::string("\x46\0\0", 3));  // ms
    std::uint32_t size = 0;
    std::memcpy(&size, film.data() + at - 4, sizeof(size));
    const std::string chunks = "WEBP" + film.substr(at + 16, size - 16);
    const auto length = static_cast<std::uint32_t>(chunks.size());
    const std::string single =
        "RIFF" + std::string(reinterpret_cast<const char*>(&length), sizeof(length)) + chunks;
    int width = 0;
    int height = 0;
    std::uint8_t* pixels = WebPDecodeRGBA(reinterpret_cast<const std::uint8_t*>(single.data()),
                                          single.size(), &width, &height);
    REQUIRE(pixels != nullptr);
    CHECK(width == 20);
    CHECK(std::abs(pixels[2] - blue) < 6);
    WebPFree(pixels);
  }
  CHECK_THROWS_AS(EncodeWebpFilm({}, 70, 80), std::invalid_argument);
}

TEST_CASE("a frame of a WebP film has only what differs from the frame before it") {
  std::vector<Image> frames(6, Flat(64, 64, {0, 0, 0, 255}));
  for (std::size_t i = 0; i < frames.size(); ++i) {
    std::uint32_t noise = 1;
    for (std::size_t k = 0; k < 4UL * 64 * 64; k += 4) {
      noise = 1664525 * noise + 1013904223;
      frames[i].rgba[k] = static_cast<std::uint8_t>(noise >> 24);
    }
    frames[i].rgba[4 * i + 1] = 255;
  }
  CHECK(EncodeWebpFilm(frames, 70, 80).size() < 2 * EncodeWebpFast(frames[0], 80).size());
}

}  // namespace
}  // namespace mjforge::picture
