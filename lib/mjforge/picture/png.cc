#include <png.h>

#include <stdexcept>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

// Pictures are smooth: more effort takes long and saves little.
constexpr int kCompression = 5;

extern "C" void AppendPng(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))
      ->append(reinterpret_cast<const char*>(bytes), count);
}
extern "C" void FlushPng(png_structp) {}
[[noreturn]] void ThrowPng(png_structp, png_const_charp message) {
  throw std::runtime_error(message);
}

// What libpng allocated, until the end.
struct PngWriter {
  PngWriter() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, ThrowPng, nullptr)) {
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) throw std::bad_alloc();
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  png_structp png = nullptr;
  png_infop info = nullptr;
};

bool IsOpaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) {
    if (image.rgba[i] != 255) return false;
  }
  return true;
}

void SetTexts(PngWriter& writer, const Texts& texts) {
  std::vector<png_text> chunks;
  for (const auto& [key, value] : texts) {
    png_text& chunk = chunks.emplace_back();
    chunk.compression = PNG_TEXT_COMPRESSION_NONE;
    // libpng only reads them.
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(value.c_str());
    chunk.text_length = value.size();
  }
  png_set_text(writer.png, writer.info, chunks.data(), static_cast<int>(chunks.size()));
}

}  // namespace

std::string EncodePng(const Image& image, const Texts& texts) {
  std::string bytes;
  PngWriter writer;
  png_set_write_fn(writer.png, &bytes, AppendPng, FlushPng);
  png_set_compression_level(writer.png, kCompression);
  const bool opaque = IsOpaque(image);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  SetTexts(writer, texts);
  png_write_info(writer.png, writer.info);
  if (opaque) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);
  const std::size_t stride = static_cast<std::size_t>(image.width) * 4;
  for (int y = 0; y < image.height; ++y) {
    png_write_row(writer.png, image.rgba.data() + static_cast<std::size_t>(y) * stride);
  }
  png_write_end(writer.png, nullptr);
  return bytes;
}

}  // namespace mjforge::picture
