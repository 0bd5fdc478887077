// Decoded PNG files for tests.

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::harness {

/// A picture decoded by libpng.
struct Png {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  // rows from the top

  std::array<int, 4> At(int x, int y) const;
  /// Counts pixels that differ from their left neighbour by more than `step` in a channel.
  int Edges(int step) const;
  /// Counts pixels with an alpha above 2 of 255.
  int Seen() const;
};

/// Fails the test if the bytes are not a PNG file.
Png DecodePng(std::string_view bytes);

/// Returns the names and lengths of the file's chunks in order: "IHDR 13".
std::vector<std::string> PngChunks(std::string_view bytes);
/// Returns the text of the tEXt chunk with this key, or an empty text.
std::string PngText(std::string_view bytes, std::string_view key);

}  // namespace mjforge::harness
