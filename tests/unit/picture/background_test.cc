#include <catch2/catch.hpp>

#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

TEST_CASE("a background is a word or a color in hexadecimal digits") {
  CHECK(ParseBackground("#10fF03")->top == Background::Color{16, 255, 3});
  CHECK(ParseBackground("white")->bottom == Background::Color{255, 255, 255});
  CHECK(ParseBackground("transparent")->transparent);
  CHECK_FALSE(ParseBackground("studio")->transparent);
  for (const char* wrong : {"", "blue", "#12345", "#1234567", "#12345g", "#+12345", "123456"}) {
    INFO(wrong);
    CHECK_FALSE(ParseBackground(wrong).has_value());
  }
}

TEST_CASE("layers are found by their names") {
  CHECK(LayerNames().size() == 6);
  CHECK(ParseLayer("visual") == Layer::kVisual);
  CHECK(ParseLayer("joints") == Layer::kJoints);
  CHECK(ParseLayer("regions") == Layer::kRegions);
  CHECK_FALSE(ParseLayer("joint").has_value());
}

TEST_CASE("a background goes from its top color to its bottom color, behind the image") {
  Image image{1, 3, {0, 0, 0, 0, 200, 100, 0, 255, 0, 0, 0, 51}};
  PutBehind({{10, 20, 30}, {50, 60, 70}, false}, image);
  CHECK(image.rgba ==
        std::vector<std::uint8_t>{10, 20, 30, 255, 200, 100, 0, 255, 40, 48, 56, 255});
}

TEST_CASE("on a transparent background an image stays as it is") {
  Image image{1, 1, {1, 2, 3, 4}};
  PutBehind({.transparent = true}, image);
  CHECK(image.rgba == std::vector<std::uint8_t>{1, 2, 3, 4});
}

}  // namespace
}  // namespace mjforge::picture
