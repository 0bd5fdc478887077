// Generation of the pixels of built-in textures (gradient, checker, flat).

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/engine/engine.h"
#include "mjforge/model/model.h"

namespace mjforge::files {

/// Pixels of three bytes (red, green, blue), starting with the top row. The six sides of a cube map
/// are one below the other.
struct TexturePixels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Generates a texture with MuJoCo. Random marks (`mark="random"`) are made by mjforge, with the
/// density of MuJoCo's marks, because MuJoCo's own marks differ between releases, and between the
/// textures of a file. Returns nullopt and sets `why_not` if MuJoCo rejects the texture.
std::optional<TexturePixels> PixelsOf(const model::Texture& texture, engine::Engine& engine,
                                      std::string& why_not);

}  // namespace mjforge::files
