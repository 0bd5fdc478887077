// Lossy WebP of an image.

#include <webp/encode.h>

#include <memory>
#include <new>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

// Method of libwebp, from 0 (fastest) to 6 (smallest file).
constexpr int kDefaultMethod = 4;
constexpr int kFastMethod = 0;

std::string Encode(const Image& image, int quality, int method) {
  WebPConfig config;
  WebPPicture picture;
  if (WebPConfigInit(&config) == 0 || WebPPictureInit(&picture) == 0) throw std::bad_alloc();
  config.quality = static_cast<float>(quality);
  config.method = method;
  WebPMemoryWriter writer;
  WebPMemoryWriterInit(&writer);
  picture.width = image.width;
  picture.height = image.height;
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &writer;
  const bool is_done = WebPPictureImportRGBA(&picture, image.rgba.data(), 4 * image.width) != 0 &&
                       WebPEncode(&config, &picture) != 0;
  WebPPictureFree(&picture);
  const std::unique_ptr<WebPMemoryWriter, void (*)(WebPMemoryWriter*)> owner(&writer,
                                                                             WebPMemoryWriterClear);
  if (!is_done) throw std::bad_alloc();
  return {reinterpret_cast<const char*>(writer.mem), writer.size};
}

}  // namespace

std::string EncodeWebp(const Image& image, int quality) {
  return Encode(image, quality, kDefaultMethod);
}

std::string EncodeWebpFast(const Image& image, int quality) {
  return Encode(image, quality, kFastMethod);
}

}  // namespace mjforge::picture
