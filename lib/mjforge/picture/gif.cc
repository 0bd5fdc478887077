// Encoder of animated GIFs: chooses one palette for all frames, and writes the frames with giflib.

#include <fmt/format.h>
#include <gif_lib.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>
#include <unordered_map>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

constexpr std::size_t kMaxColors = 255;
constexpr GifPixelType kTransparent = 255;  // palette index of transparent pixels
// Pixels with at least this alpha are opaque, because GIF has no partial transparency.
constexpr int kMinAlpha = 128;

struct CountedColor {
  Background::Color rgb;
  double count;  // number of pixels
};

// Colors that become one color of the palette: their mean over all pixels of these colors.
struct ColorBox {
  std::span<CountedColor> colors;
  Background::Color mean = {};
  std::size_t channel = 0;  // channel with the largest error
  double error = 0;         // sum over pixels of squared differences from the mean in this channel
  double middle = 0;        // mean of this channel, not rounded

  explicit ColorBox(std::span<CountedColor> all) : colors(all) {
    for (std::size_t c = 0; c < mean.size(); ++c) {
      double count = 0;
      double sum = 0;
      double squares = 0;
      for (const CountedColor& color : colors) {
        count += color.count;
        sum += color.count * color.rgb[c];
        squares += color.count * color.rgb[c] * color.rgb[c];
      }
      mean[c] = static_cast<std::uint8_t>(std::lround(sum / count));
      const double error_of_channel = squares - sum * sum / count;
      if (error_of_channel <= error) continue;
      channel = c;
      error = error_of_channel;
      middle = sum / count;
    }
  }
};

// Splits the box with the largest error at its mean, until there are kMaxColors boxes or each box
// has a single color. Source: S. J. Wan, S. K. M. Wong and P. Prusinkiewicz, "An algorithm for
// multidimensional data clustering", ACM Transactions on Mathematical Software 14, 1988.
std::vector<ColorBox> SplitColors(std::vector<CountedColor>& colors) {
  // A box with two colors has an error of at least 0.5; smaller errors are rounding errors of 0.
  constexpr double kRounding = 0.25;
  std::vector<ColorBox> boxes = {ColorBox(colors)};
  while (boxes.size() < kMaxColors) {
    ColorBox& worst = *std::ranges::max_element(boxes, {}, &ColorBox::error);
    if (worst.error < kRounding) break;
    const std::span<CountedColor> all = worst.colors;
    const auto middle = std::partition(all.begin(), all.end(), [&](const CountedColor& color) {
      return color.rgb[worst.channel] <= worst.middle;
    });
    const auto lower = static_cast<std::size_t>(middle - all.begin());
    worst = ColorBox(all.first(lower));
    boxes.emplace_back(all.subspan(lower));
  }
  return boxes;
}

std::uint32_t KeyOf(const std::uint8_t* rgb) {
  return static_cast<std::uint32_t>(rgb[0] << 16 | rgb[1] << 8 | rgb[2]);
}

struct Palette {
  std::array<GifColorType, 256> colors = {};
  std::unordered_map<std::uint32_t, GifPixelType> indices;  // palette indices, by KeyOf the color
  bool has_holes = false;                                   // true if any pixel is transparent

  explicit Palette(std::span<const Image> frames) {
    std::unordered_map<std::uint32_t, CountedColor> counted;
    for (const Image& frame : frames) {
      for (std::size_t i = 0; i < frame.rgba.size(); i += 4) {
        const std::uint8_t* pixel = frame.rgba.data() + i;
        if (pixel[3] < kMinAlpha) {
          has_holes = true;
        } else {
          ++counted.try_emplace(KeyOf(pixel), CountedColor{{pixel[0], pixel[1], pixel[2]}, 0})
                .first->second.count;
        }
      }
    }
    auto all = diag::Mapped<CountedColor>(counted, [](const auto& entry) { return entry.second; });
    if (all.empty()) return;
    GifPixelType index = 0;
    for (const ColorBox& box : SplitColors(all)) {
      colors[index] = {box.mean[0], box.mean[1], box.mean[2]};
      for (const CountedColor& color : box.colors) indices[KeyOf(color.rgb.data())] = index;
      ++index;
    }
  }

  std::vector<GifPixelType> IndicesOf(const Image& frame) const {
    std::vector<GifPixelType> pixels(frame.rgba.size() / 4, kTransparent);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const std::uint8_t* pixel = frame.rgba.data() + 4 * i;
      if (pixel[3] >= kMinAlpha) pixels[i] = indices.at(KeyOf(pixel));
    }
    return pixels;
  }
};

extern "C" int AppendGif(GifFileType* gif, const GifByteType* bytes, int count) {
  static_cast<std::string*>(gif->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
  return count;
}

struct CloseGif {
  void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
};
using GifFile = std::unique_ptr<GifFileType, CloseGif>;

void CheckGif(const GifFile& gif, int status) {
  if (status != GIF_OK) throw std::runtime_error(GifErrorString(gif->Error));
}

// Writes the extension that makes viewers repeat the animation endlessly.
void PutLoop(const GifFile& gif) {
  constexpr std::array<GifByteType, 3> kForever = {1, 0, 0};
  CheckGif(gif, EGifPutExtensionLeader(gif.get(), APPLICATION_EXT_FUNC_CODE));
  CheckGif(gif, EGifPutExtensionBlock(gif.get(), 11, "NETSCAPE2.0"));
  CheckGif(gif, EGifPutExtensionBlock(gif.get(), 3, kForever.data()));
  CheckGif(gif, EGifPutExtensionTrailer(gif.get()));
}

void PutFrame(const GifFile& gif, const Image& frame, std::vector<GifPixelType> pixels, int delay,
              int disposal) {
  GraphicsControlBlock control = {};
  control.DisposalMode = disposal;
  control.DelayTime = delay / 10;
  control.TransparentColor = kTransparent;
  std::array<GifByteType, 4> block = {};
  EGifGCBToExtension(&control, block.data());
  CheckGif(gif, EGifPutExtension(gif.get(), GRAPHICS_EXT_FUNC_CODE, 4, block.data()));
  CheckGif(gif, EGifPutImageDesc(gif.get(), 0, 0, frame.width, frame.height, false, nullptr));
  CheckGif(gif, EGifPutLine(gif.get(), pixels.data(), static_cast<int>(pixels.size())));
}

}  // namespace

std::string EncodeGif(std::span<const Image> frames, int delay, const Texts& texts) {
  if (frames.empty()) throw std::invalid_argument("an animation without frames");
  Palette palette(frames);
  const ColorMapObject map = {256, 8, false, palette.colors.data()};
  std::string bytes;
  GifFile gif(EGifOpen(&bytes, AppendGif, nullptr));
  if (!gif) throw std::bad_alloc();
  EGifSetGifVersion(gif.get(), true);
  CheckGif(gif, EGifPutScreenDesc(gif.get(), frames[0].width, frames[0].height, 8, 0, &map));
  for (const auto& [key, value] : texts)
    CheckGif(gif, EGifPutComment(gif.get(), fmt::format("{}: {}", key, value).c_str()));
  PutLoop(gif);
  std::vector<GifPixelType> before;
  for (const Image& frame : frames) {
    const std::vector<GifPixelType> pixels = palette.IndicesOf(frame);
    std::vector<GifPixelType> changed = pixels;
    // Leaves unchanged pixels transparent, which makes the file smaller. If any pixel of the
    // animation is transparent, writes all pixels of each frame, because viewers then clear the
    // screen after each frame (DISPOSE_BACKGROUND).
    for (std::size_t i = 0; !palette.has_holes && i < before.size(); ++i) {
      if (pixels[i] == before[i]) changed[i] = kTransparent;
    }
    PutFrame(gif, frame, std::move(changed), delay,
             palette.has_holes ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT);
    before = pixels;
  }
  gif.reset();
  return bytes;
}

}  // namespace mjforge::picture
