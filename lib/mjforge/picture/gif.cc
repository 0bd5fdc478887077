#include <fmt/format.h>
#include <gif_lib.h>

#include <array>
#include <stdexcept>

#include "mjforge/picture/palette.h"

namespace mjforge::picture {
namespace {

constexpr std::size_t kMostColors = 255;  // the last one stands for "nothing"
constexpr int kTransparent = 255;
constexpr int kVisible = 128;  // of 255: GIF knows no half-transparent pixels

extern "C" int AppendGif(GifFileType* gif, const GifByteType* bytes, int count) {
  static_cast<std::string*>(gif->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
  return count;
}

// What giflib allocated, until the end.
struct FreeGif {
  void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using GifFile = std::unique_ptr<GifFileType, FreeGif>;
using GifMap = std::unique_ptr<ColorMapObject, FreeGif>;

void CheckGif(const GifFile& gif, int status) {
  if (status != GIF_OK) throw std::runtime_error(GifErrorString(gif->Error));
}

GifMap MapOf(const Palette& palette) {
  constexpr int kColors = 256;
  std::array<GifColorType, kColors> colors = {};
  for (std::size_t i = 0; i < palette.colors().size(); ++i) {
    const Background::Color& color = palette.colors()[i];
    colors[i] = {color[0], color[1], color[2]};
  }
  GifMap map(GifMakeMapObject(kColors, colors.data()));
  if (!map) throw std::bad_alloc();
  return map;
}

// For ever, as browsers read it.
void PutLoop(const GifFile& gif) {
  const std::array<GifByteType, 3> forever = {1, 0, 0};
  CheckGif(gif, EGifPutExtensionLeader(gif.get(), APPLICATION_EXT_FUNC_CODE));
  CheckGif(gif, EGifPutExtensionBlock(gif.get(), 11, "NETSCAPE2.0"));
  CheckGif(gif, EGifPutExtensionBlock(gif.get(), 3, forever.data()));
  CheckGif(gif, EGifPutExtensionTrailer(gif.get()));
}

void PutFrame(const GifFile& gif, const Image& image, const Palette& palette, int delay) {
  GraphicsControlBlock control = {};
  control.DisposalMode = DISPOSE_BACKGROUND;
  control.DelayTime = delay / 10;
  control.TransparentColor = kTransparent;
  std::array<GifByteType, 4> block = {};
  EGifGCBToExtension(&control, block.data());
  CheckGif(gif, EGifPutExtension(gif.get(), GRAPHICS_EXT_FUNC_CODE, 4, block.data()));
  CheckGif(gif, EGifPutImageDesc(gif.get(), 0, 0, image.width, image.height, false, nullptr));
  std::vector<GifPixelType> line(static_cast<std::size_t>(image.width));
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* pixel = image.rgba.data() + static_cast<std::size_t>(y) * line.size() * 4;
    for (GifPixelType& number : line) {
      number = pixel[3] < kVisible ? kTransparent : palette.Nearest(pixel);
      pixel += 4;
    }
    CheckGif(gif, EGifPutLine(gif.get(), line.data(), image.width));
  }
}

}  // namespace

std::string EncodeGif(std::span<const Image> frames, int delay, const Texts& texts) {
  if (frames.empty()) throw std::invalid_argument("an animation without frames");
  std::string bytes;
  const Palette palette(frames, kMostColors);
  const auto map = MapOf(palette);
  {
    int error = 0;
    const GifFile gif(EGifOpen(&bytes, AppendGif, &error));
    if (!gif) throw std::runtime_error(GifErrorString(error));
    EGifSetGifVersion(gif.get(), true);
    CheckGif(gif, EGifPutScreenDesc(gif.get(), frames.front().width, frames.front().height, 8, 0,
                                    map.get()));
    for (const auto& [key, value] : texts) {
      const std::string comment = fmt::format("{}: {}", key, value);
      CheckGif(gif, EGifPutComment(gif.get(), comment.c_str()));
    }
    PutLoop(gif);
    for (const Image& frame : frames) PutFrame(gif, frame, palette, delay);
  }
  return bytes;
}

}  // namespace mjforge::picture
