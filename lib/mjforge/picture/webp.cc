// Lossy WebP of an image.

#include <webp/encode.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>

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

// Returns a number in `count` bytes, the lowest first.
std::string Bytes(std::size_t number, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
  return bytes;
}

// Returns a chunk of a RIFF file, whose length is even.
std::string Chunk(std::string_view name, std::string_view content) {
  std::string chunk = std::string(name) + Bytes(content.size(), 4) + std::string(content);
  if (content.size() % 2 != 0) chunk += '\0';
  return chunk;
}

}  // namespace

// Chunks by the WebP Container Specification
// (developers.google.com/speed/webp/docs/riff_container).
std::string EncodeWebpFilm(std::span<const Image> frames, int delay, int quality) {
  if (frames.empty()) throw std::invalid_argument("an animation without frames");
  const auto size = [](const Image& image) {
    return Bytes(static_cast<std::size_t>(image.width - 1), 3) +
           Bytes(static_cast<std::size_t>(image.height - 1), 3);
  };
  constexpr std::size_t kAnimation = 0x02;   // flag in VP8X
  constexpr std::size_t kDoNotBlend = 0x02;  // flag in ANMF
  constexpr std::size_t kFirstChunk = 12;    // offset behind RIFF, length and WEBP
  std::string body = "WEBP" + Chunk("VP8X", Bytes(kAnimation, 4) + size(frames.front()));
  body += Chunk("ANIM", Bytes(0xffffffff, 4) + Bytes(0, 2));  // white behind, endless
  for (const Image& frame : frames) {
    const std::string single = EncodeWebpFast(frame, quality);
    body += Chunk("ANMF", Bytes(0, 3) + Bytes(0, 3) + size(frame) +
                              Bytes(static_cast<std::size_t>(delay), 3) + Bytes(kDoNotBlend, 1) +
                              single.substr(kFirstChunk));
  }
  return Chunk("RIFF", body);
}

std::string EncodeWebp(const Image& image, int quality) {
  return Encode(image, quality, kDefaultMethod);
}

std::string EncodeWebpFast(const Image& image, int quality) {
  return Encode(image, quality, kFastMethod);
}

}  // namespace mjforge::picture
