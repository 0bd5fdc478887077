// Lossy WebP of an image.

#include <webp/encode.h>

#include <new>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

std::string EncodeWebp(const Image& image, int quality) {
  std::uint8_t* bytes = nullptr;
  const std::size_t count = WebPEncodeRGBA(image.rgba.data(), image.width, image.height,
                                           4 * image.width, static_cast<float>(quality), &bytes);
  if (count == 0) throw std::bad_alloc();
  std::string webp(reinterpret_cast<const char*>(bytes), count);
  WebPFree(bytes);
  return webp;
}

}  // namespace mjforge::picture
