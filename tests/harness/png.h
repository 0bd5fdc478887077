#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::harness {

/// A PNG file as libpng reads it.
struct Png {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  // rows from the top

  std::array<int, 4> At(int x, int y) const;
  /// Pixels that differ from the one to their left by more than `step` in a channel.
  int Edges(int step) const;
  /// Pixels that are not quite transparent.
  int Seen() const;
};

/// Fails the test if the bytes are no PNG.
Png DecodePng(std::string_view bytes);

/// The names of the file's chunks, in order, each with its length: "IHDR 13".
std::vector<std::string> PngChunks(std::string_view bytes);
/// The text of the chunk tEXt with this key; empty if there is none.
std::string PngText(std::string_view bytes, std::string_view key);

}  // namespace mjforge::harness
