// Generation of built-in textures by MuJoCo, with reproducible random marks.

#include "mjforge/files/texture.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <span>
#include <string_view>

#include "mjforge/mjcf/mjcf.h"

namespace mjforge::files {
namespace {

// Gives each pixel the mark's color with the probability in the attribute `random` (default 0.01),
// independently of other pixels. Truncates the color to bytes, like MuJoCo.
void AddRandomMarks(const model::Texture& texture, TexturePixels& picture) {
  const model::Attribute* share = model::FindAttribute(texture.attributes, "random");
  const model::Attribute* color = model::FindAttribute(texture.attributes, "markrgb");
  const double probability = share != nullptr ? share->numbers[0] : 0.01;
  std::array<std::uint8_t, 3> mark = {};
  for (std::size_t i = 0; color != nullptr && i < mark.size(); ++i)
    mark[i] = static_cast<std::uint8_t>(255 * color->numbers[i]);
  std::mt19937_64 random;  // reproducible: the C++ standard defines its numbers
  constexpr double kUnit = 0x1p-64;
  for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
    if (static_cast<double>(random()) * kUnit < probability)
      std::ranges::copy(mark, picture.rgb.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

std::optional<TexturePixels> PixelsOf(const model::Texture& texture, engine::Engine& engine,
                                      std::string& why_not) {
  const engine::Loaded loaded =
      engine.LoadText("<mujoco><asset>" + mjcf::TextureElement(texture) + "</asset></mujoco>");
  if (!loaded.model) return diag::Refuse(why_not, engine::ParseRefusal(loaded.error).reason);
  TexturePixels picture = {.width = static_cast<int>(loaded.model->tex_width[0]),
                           .height = static_cast<int>(loaded.model->tex_height[0]),
                           .rgb = {}};
  const std::span<const std::uint8_t> pixels = engine::PixelsOf(*loaded.model, 0);
  picture.rgb.assign(pixels.begin(), pixels.end());
  const model::Attribute* mark = model::FindAttribute(texture.attributes, "mark");
  if (mark != nullptr && mark->text == "random") AddRandomMarks(texture, picture);
  return picture;
}

}  // namespace mjforge::files
