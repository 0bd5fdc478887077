#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
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

class Writer {
 public:
  explicit Writer(std::string& out) {
    int error = 0;
    gif_ = EGifOpen(&out, AppendGif, &error);
    if (gif_ == nullptr) throw std::runtime_error(GifErrorString(error));
  }
  ~Writer() {
    int ignored = 0;
    EGifCloseFile(gif_, &ignored);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  GifFileType* operator*() { return gif_; }
  void Check(int status) const {
    if (status != GIF_OK) throw std::runtime_error(GifErrorString(gif_->Error));
  }

 private:
  GifFileType* gif_ = nullptr;
};

struct FreeMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};

std::unique_ptr<ColorMapObject, FreeMap> MapOf(const Palette& palette) {
  constexpr int kColors = 256;
  std::array<GifColorType, kColors> colors = {};
  for (std::size_t i = 0; i < palette.colors().size(); ++i) {
    const Background::Color& color = palette.colors()[i];
    colors[i] = {color[0], color[1], color[2]};
  }
  std::unique_ptr<ColorMapObject, FreeMap> map(GifMakeMapObject(kColors, colors.data()));
  if (!map) throw std::bad_alloc();
  return map;
}

// For ever, as browsers read it.
void PutLoop(Writer& writer) {
  const std::array<GifByteType, 3> forever = {1, 0, 0};
  writer.Check(EGifPutExtensionLeader(*writer, APPLICATION_EXT_FUNC_CODE));
  writer.Check(EGifPutExtensionBlock(*writer, 11, "NETSCAPE2.0"));
  writer.Check(EGifPutExtensionBlock(*writer, 3, forever.data()));
  writer.Check(EGifPutExtensionTrailer(*writer));
}

void PutFrame(Writer& writer, const Image& image, const Palette& palette, int delay) {
  GraphicsControlBlock control = {};
  control.DisposalMode = DISPOSE_BACKGROUND;
  control.DelayTime = delay / 10;
  control.TransparentColor = kTransparent;
  std::array<GifByteType, 4> block = {};
  EGifGCBToExtension(&control, block.data());
  writer.Check(EGifPutExtension(*writer, GRAPHICS_EXT_FUNC_CODE, 4, block.data()));
  writer.Check(EGifPutImageDesc(*writer, 0, 0, image.width, image.height, false, nullptr));
  std::vector<GifPixelType> line(static_cast<std::size_t>(image.width));
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* pixel = image.rgba.data() + static_cast<std::size_t>(y) * line.size() * 4;
    for (GifPixelType& number : line) {
      number = pixel[3] < kVisible ? kTransparent : palette.Nearest(pixel);
      pixel += 4;
    }
    writer.Check(EGifPutLine(*writer, line.data(), image.width));
  }
}

}  // namespace

std::string EncodeGif(std::span<const Image> frames, int delay, const Texts& texts) {
  if (frames.empty()) throw std::invalid_argument("an animation without frames");
  std::string bytes;
  const Palette palette(frames, kMostColors);
  const auto map = MapOf(palette);
  {
    Writer writer(bytes);
    EGifSetGifVersion(*writer, true);
    writer.Check(
        EGifPutScreenDesc(*writer, frames.front().width, frames.front().height, 8, 0, map.get()));
    for (const auto& [key, value] : texts) {
      const std::string comment = fmt::format("{}: {}", key, value);
      writer.Check(EGifPutComment(*writer, comment.c_str()));
    }
    PutLoop(writer);
    for (const Image& frame : frames) PutFrame(writer, frame, palette, delay);
  }
  return bytes;
}

}  // namespace mjforge::picture
