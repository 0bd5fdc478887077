#include "mjforge/files/texture.h"

#include <catch2/catch.hpp>

#include "attributes.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::files {
namespace {

model::Texture Generated(const std::string& type, const std::string& builtin,
                         const std::string& mark) {
  model::Texture texture;
  texture.name = "grain";
  texture.attributes = {Word("type", type),
                        Word("builtin", builtin),
                        Numbers("rgb1", {0.81, 0.7, 0.6}),
                        Numbers("rgb2", {0.3, 0.2, 0.13}),
                        Word("mark", mark),
                        Numbers("markrgb", {0.5, 0.1, 0.9}),
                        Numbers("random", {0.3}),
                        Numbers("width", {40}),
                        Numbers("height", {type == "2d" ? 24.0 : 40.0})};
  return texture;
}

TexturePixels Made(const model::Texture& texture) {
  engine::Engine engine;
  std::string why_not;
  const std::optional<TexturePixels> picture = PixelsOf(texture, engine, why_not);
  INFO(why_not);
  REQUIRE(picture);
  return *picture;
}

std::string ModelWith(const std::string& attributes) {
  return "<mujoco><asset><texture name=\"t\" rgb1=\"0.81 0.7 0.6\" rgb2=\"0.3 0.2 0.13\" "
         "markrgb=\"0.5 0.1 0.9\" random=\"0.3\" width=\"40\" " +
         attributes + "/></asset></mujoco>";
}

TEST_CASE("a generated texture is what MuJoCo generates") {
  engine::Engine engine;
  for (const std::string type : {"2d", "cube"}) {
    for (const std::string builtin : {"flat", "checker", "gradient"}) {
      for (const std::string mark : {"none", "edge", "cross"}) {
        INFO(type << ' ' << builtin << ' ' << mark);
        const TexturePixels picture = Made(Generated(type, builtin, mark));
        const engine::Loaded loaded = engine.LoadText(
            ModelWith("height=\"" + std::string(type == "2d" ? "24" : "40") + "\" type=\"" + type +
                      "\" builtin=\"" + builtin + "\" mark=\"" + mark + "\""));
        REQUIRE(loaded.model);
        CHECK(picture.width == loaded.model->tex_width[0]);
        CHECK(picture.height == loaded.model->tex_height[0]);
        CHECK(std::ranges::equal(picture.rgb, engine::PixelsOf(*loaded.model, 0)));
      }
    }
  }
}

TEST_CASE("random marks are as dense as MuJoCo's, in its colour") {
  const TexturePixels plain = Made(Generated("2d", "gradient", "none"));
  const TexturePixels marked = Made(Generated("2d", "gradient", "random"));
  const std::array<std::uint8_t, 3> mark = {127, 25, 229};
  int marks = 0;
  REQUIRE(marked.rgb.size() == plain.rgb.size());
  for (std::size_t i = 0; i < marked.rgb.size(); i += 3) {
    const std::span<const std::uint8_t> pixel(&marked.rgb[i], 3);
    const bool is_mark = std::ranges::equal(pixel, mark);
    marks += is_mark;
    if (!is_mark) CHECK(std::ranges::equal(pixel, std::span(&plain.rgb[i], 3)));
  }
  const engine::Loaded loaded = engine::Engine().LoadText(
      ModelWith("height=\"24\" type=\"2d\" builtin=\"flat\" mark=\"random\""));
  REQUIRE(loaded.model);
  const auto pixels = engine::PixelsOf(*loaded.model, 0);
  int theirs = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 3)
    theirs += std::ranges::equal(pixels.subspan(i, 3), mark);
  // 0.3 of 960; one standard deviation is 14.
  CHECK(std::abs(marks - 288) < 43);
  CHECK(std::abs(theirs - 288) < 43);
}

TEST_CASE("the default of random marks is one pixel of a hundred, black") {
  model::Texture texture;
  texture.attributes = {Word("builtin", "flat"), Word("mark", "random"), Numbers("width", {100}),
                        Numbers("height", {100})};
  const TexturePixels picture = Made(texture);
  const auto black = std::ranges::count(picture.rgb, 0) / 3;
  CHECK(black > 450);  // of 60,000 in six sides; one standard deviation is 24
  CHECK(black < 750);
}

TEST_CASE("what MuJoCo refuses is told") {
  model::Texture texture = Generated("2d", "flat", "none");
  texture.attributes[1].text = "dots";
  engine::Engine engine;
  std::string why_not;
  CHECK_FALSE(PixelsOf(texture, engine, why_not));
  CHECK(why_not.find("dots") != std::string::npos);
}

}  // namespace
}  // namespace mjforge::files
