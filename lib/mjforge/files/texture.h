#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/engine/engine.h"
#include "mjforge/model/model.h"

namespace mjforge::files {

/// Rows from the top, red, green, blue; of a cube its six sides, one below the other.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// A generated texture, as MuJoCo makes it. Only random marks are ours, as dense as its own: those
/// differ between its releases, and from one texture of a file to the next. Nothing, and why, if
/// MuJoCo refuses it.
std::optional<Picture> PictureOf(const model::Texture& texture, engine::Engine& engine,
                                 std::string& why_not);

}  // namespace mjforge::files
