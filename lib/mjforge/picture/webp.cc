// Encoding of images and animations as lossy WebP.

#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>
#include <new>
#include <stdexcept>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

// Values of WebPConfig::method, from 0 (fastest) to 6 (smallest file).
constexpr int kDefaultMethod = 4;
constexpr int kFastMethod = 0;

// Calls `encode` with a WebPConfig and a WebPPicture that has the pixels of the image; `encode`
// returns false if it fails. `is_argb` keeps the pixels as ARGB instead of YUV.
void Encode(const Image& image, int quality, int method, bool is_argb, const auto& encode) {
  WebPConfig config;
  WebPPicture picture;
  if (WebPConfigInit(&config) == 0 || WebPPictureInit(&picture) == 0) throw std::bad_alloc();
  config.quality = static_cast<float>(quality);
  config.method = method;
  picture.use_argb = is_argb ? 1 : 0;
  picture.width = image.width;
  picture.height = image.height;
  const bool is_done = WebPPictureImportRGBA(&picture, image.rgba.data(), 4 * image.width) != 0 &&
                       encode(config, picture);
  WebPPictureFree(&picture);
  if (!is_done) throw std::bad_alloc();
}

std::string EncodeOne(const Image& image, int quality, int method) {
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  const std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter*)> owner(&writer,
                                                                             WebPMemoryWriterClear);
  Encode(image, quality, method, false, [&](const WebPConfig& config, WebPPicture& picture) {
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
    return WebPEncode(&config, &picture) != 0;
  });
  return {reinterpret_cast<const char*>(writer.mem), writer.size};
}

}  // namespace

// libwebp stores in each frame only the rectangle that differs from the frame before.
std::string EncodeWebpFilm(std::span<const Image> frames, int delay, int quality) {
  if (frames.empty()) throw std::invalid_argument("an animation without frames");
  WebPAnimEncoderOptions options;
  if (WebPAnimEncoderOptionsInit(&options) == 0) throw std::bad_alloc();
  const std::unique_ptr<WebPAnimEncoder, void (*)(WebPAnimEncoder*)> encoder(
      WebPAnimEncoderNew(frames.front().width, frames.front().height, &options),
      WebPAnimEncoderDelete);
  int time = 0;  // ms
  for (const Image& frame : frames) {
    Encode(frame, quality, kFastMethod, true, [&](const WebPConfig& config, WebPPicture& picture) {
      return WebPAnimEncoderAdd(encoder.get(), &picture, time, &config) != 0;
    });
    time += delay;
  }
  WebPData file = {};
  const std::unique_ptr<WebPData, void (*)(WebPData*)> owner(&file, WebPDataClear);
  if (WebPAnimEncoderAdd(encoder.get(), nullptr, time, nullptr) == 0 ||
      WebPAnimEncoderAssemble(encoder.get(), &file) == 0)
    throw std::bad_alloc();
  return {reinterpret_cast<const char*>(file.bytes), file.size};
}

std::string EncodeWebp(const Image& image, int quality) {
  return EncodeOne(image, quality, kDefaultMethod);
}

std::string EncodeWebpFast(const Image& image, int quality) {
  return EncodeOne(image, quality, kFastMethod);
}

}  // namespace mjforge::picture
