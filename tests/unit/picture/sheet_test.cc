#include "mjforge/picture/sheet.h"

#include "images.h"
#include "models.h"

namespace mjforge::picture {
namespace {

TEST_CASE("an image over another covers it by its alpha, and what sticks out is cut") {
  Image below = Flat(2, 2, {100, 100, 100, 255});
  PutOver(Flat(2, 2, {200, 0, 0, 127}), 1, -1, below);
  CHECK(below.rgba[0] == 100);
  CHECK(below.rgba[4] == 150);
  CHECK(below.rgba[5] == 50);
  CHECK(below.rgba[7] == 255);
  CHECK(below.rgba[12] == 100);
  PutOver(Flat(1, 1, {1, 1, 1, 255}), 9, 9, below);
  CHECK(below.rgba[12] == 100);
}

TEST_CASE("labels that would cover each other are moved apart") {
  Image image = Flat(60, 60, {0, 0, 0, 255});
  const Image text = Flat(20, 10, {255, 0, 0, 255});
  PutLabels({{text, 10, 10}, {text, 12, 12}, {text, 55, 10}}, image);
  const auto red = [&](int x, int y) {
    return image.rgba[4 * static_cast<std::size_t>(60 * y + x)] == 255;
  };
  CHECK(red(10, 10));
  CHECK(red(20, 19));
  CHECK_FALSE(red(20, 20));  // between the first and the second
  CHECK(red(20, 21));
  CHECK(red(57, 10));  // moved in
  CHECK_FALSE(red(58, 10));
}

TEST_CASE("a sheet is as square as the number of its tiles allows") {
  const auto renderer = OpenRenderer();
  const auto size = [&](std::size_t count) {
    const std::vector<Tile> tiles(count, {Flat(40, 30, {9, 9, 9, 255}), {}});
    const Image sheet = ContactSheet(*renderer, tiles, {.transparent = true});
    return std::pair((sheet.width - 12) / 52, (sheet.height - 12) / 42);
  };
  CHECK(size(1) == std::pair(1, 1));
  CHECK(size(4) == std::pair(2, 2));
  CHECK(size(6) == std::pair(3, 2));
  CHECK(size(16) == std::pair(4, 4));
  CHECK(size(20) == std::pair(5, 4));
}

TEST_CASE("a row of a sheet is as high as its tiles need") {
  const auto renderer = OpenRenderer();
  std::vector<Tile> tiles(4, {Flat(40, 30, {0, 0, 0, 0}), {}});
  const auto show = [&](std::size_t tile, std::size_t y) {
    tiles[tile].image.rgba[4 * (40 * y + 20) + 3] = 255;
  };
  show(0, 10);
  show(1, 14);
  show(2, 29);
  const Image sheet = ContactSheet(*renderer, tiles, {.transparent = true});
  CHECK(sheet.height == 12 + 5 + 12 + 1 + 12);
  const auto alpha = [&](int x, int y) {
    return sheet.rgba[4 * static_cast<std::size_t>(sheet.width * y + x) + 3];
  };
  CHECK(alpha(12 + 20, 12) == 255);
  CHECK(alpha(12 + 52 + 20, 12 + 4) == 255);
  CHECK(alpha(12 + 20, 12 + 5 + 12) == 255);
}

TEST_CASE("captions stand below their tiles") {
  const auto renderer = OpenRenderer();
  const std::vector<Tile> tiles(1, {Flat(100, 20, {200, 0, 0, 255}), {"one", "two"}});
  const Image sheet = ContactSheet(*renderer, tiles, *ParseBackground("white"));
  int dark = 0;
  for (std::size_t i = 0; i < sheet.rgba.size(); i += 4)
    dark += sheet.rgba[i] < 128 && i > 4 * 32 * static_cast<std::size_t>(sheet.width) ? 1 : 0;
  CHECK(dark > 20);
}

TEST_CASE("a line of text is the same each time, and longer if it has more letters") {
  const auto renderer = OpenRenderer();
  const Image text = renderer->DrawText("handle 0.1", {1, 2, 3});
  CHECK(text.rgba == renderer->DrawText("handle 0.1", {1, 2, 3}).rgba);
  CHECK(text.width > renderer->DrawText("handle", {1, 2, 3}).width);
  CHECK(text.rgba[0] == 1);
  const std::string long_text(5000, 'x');
  CHECK(renderer->DrawText(long_text, {1, 2, 3}).width <= 1024);
  CHECK(renderer->DrawText("\xC3\xA9", {1, 2, 3}).rgba == renderer->DrawText("??", {1, 2, 3}).rgba);
}

}  // namespace
}  // namespace mjforge::picture
