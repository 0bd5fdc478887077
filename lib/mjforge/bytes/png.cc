// PNG encoding with libpng.

#include <png.h>

#include <new>
#include <stdexcept>
#include <vector>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

// Compression level of zlib. Higher levels take much longer and save few bytes of smooth pictures.
constexpr int kCompression = 5;

extern "C" void AppendPng(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))
      ->append(reinterpret_cast<const char*>(bytes), count);
}
extern "C" void FlushPng(png_structp) {}
[[noreturn]] void ThrowPng(png_structp, png_const_charp message) {
  if (std::string_view(message) == "Out of memory") throw std::bad_alloc();
  throw std::runtime_error(message);
}

// Owns the structures that libpng allocates.
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

void SetTexts(PngWriter& writer, const PngTexts& texts) {
  std::vector<png_text> chunks;
  for (const auto& [key, value] : texts) {
    png_text& chunk = chunks.emplace_back();
    chunk.compression = PNG_TEXT_COMPRESSION_NONE;
    // libpng does not change the texts, but its structure requires pointers to non-constant text.
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(value.c_str());
    chunk.text_length = value.size();
  }
  png_set_text(writer.png, writer.info, chunks.data(), static_cast<int>(chunks.size()));
}

}  // namespace

std::string EncodePng(const Pixels& pixels, const PngTexts& texts, PngEffort effort) {
  std::string bytes;
  PngWriter writer;
  png_set_write_fn(writer.png, &bytes, AppendPng, FlushPng);
  png_set_compression_level(writer.png, kCompression);
  if (effort == PngEffort::kFast) png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(pixels.width),
               static_cast<png_uint_32>(pixels.height), 8,
               pixels.has_alpha ? PNG_COLOR_TYPE_RGBA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  SetTexts(writer, texts);
  png_write_info(writer.png, writer.info);
  const std::size_t stride = static_cast<std::size_t>(pixels.width) * (pixels.has_alpha ? 4 : 3);
  for (int y = 0; y < pixels.height; ++y) {
    png_write_row(writer.png, pixels.colors.data() + static_cast<std::size_t>(y) * stride);
  }
  png_write_end(writer.png, nullptr);
  return bytes;
}

}  // namespace mjforge::bytes
