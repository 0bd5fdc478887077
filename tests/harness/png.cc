// Decoding of PNG files by libpng, and of their chunks.

#include "harness/png.h"

#include <png.h>
#include <zlib.h>

#include <catch2/catch.hpp>
#include <cstdlib>

namespace mjforge::harness {
namespace {

struct Chunk {
  std::string_view type;
  std::string_view data;
};

// Calls a function for each chunk, after checking its CRC.
std::vector<Chunk> Chunks(std::string_view bytes) {
  std::vector<Chunk> chunks;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
      value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
  };
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t length = number(at);
    REQUIRE(at + 12 + length <= bytes.size());
    const auto* start = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
    REQUIRE(crc32(0, start, static_cast<uInt>(length + 4)) == number(at + 8 + length));
    chunks.push_back({bytes.substr(at + 4, 4), bytes.substr(at + 8, length)});
    at += 12 + length;
  }
  return chunks;
}

}  // namespace

std::array<int, 4> Png::At(int x, int y) const {
  const std::size_t at = 4 * static_cast<std::size_t>(y * width + x);
  return {rgba[at], rgba[at + 1], rgba[at + 2], rgba[at + 3]};
}

int Png::Edges(int step) const {
  int edges = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 1; x < width; ++x) {
      const auto left = At(x - 1, y);
      const auto here = At(x, y);
      bool edge = false;
      for (std::size_t c = 0; c < 4; ++c) edge = edge || std::abs(left[c] - here[c]) > step;
      edges += edge ? 1 : 0;
    }
  }
  return edges;
}

int Png::Seen() const {
  int seen = 0;
  for (std::size_t i = 3; i < rgba.size(); i += 4) seen += rgba[i] > 2 ? 1 : 0;
  return seen;
}

Png DecodePng(std::string_view bytes) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) != 0);
  image.format = PNG_FORMAT_RGBA;
  Png png;
  png.width = static_cast<int>(image.width);
  png.height = static_cast<int>(image.height);
  png.rgba.resize(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, png.rgba.data(), 0, nullptr) != 0);
  return png;
}

std::vector<std::string> PngChunks(std::string_view bytes) {
  std::vector<std::string> names;
  for (const Chunk& chunk : Chunks(bytes))
    names.push_back(std::string(chunk.type) + " " + std::to_string(chunk.data.size()));
  return names;
}

std::string PngText(std::string_view bytes, std::string_view key) {
  for (const Chunk& chunk : Chunks(bytes)) {
    const bool has_key = chunk.data.starts_with(key) && chunk.data.size() > key.size() &&
                         chunk.data[key.size()] == '\0';
    if (chunk.type == "tEXt" && has_key) return std::string(chunk.data.substr(key.size() + 1));
  }
  return {};
}

}  // namespace mjforge::harness
