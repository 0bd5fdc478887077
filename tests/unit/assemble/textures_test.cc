// Tests of generated textures and pictures.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

const std::string kPaintedBall = "parts: [{name: a, type: sphere, size: [1], material: m}]\n";

TEST_CASE("a generated texture gets the pixels that MuJoCo asks for") {
  const Assembling thing(
      "materials: {m: {texture: {builtin: checker, rgb1: [1, 0, 0], width: 32}}}\n" + kPaintedBall);
  REQUIRE(thing.object().textures.size() == 1);
  const model::Texture& texture = thing.object().textures[0];
  CHECK(texture.name == "thing_m");
  CHECK(model::FindAttribute(texture.attributes, "builtin")->text == "checker");
  CHECK(model::FindAttribute(texture.attributes, "width")->numbers == sample::Numbers{32});
  CHECK(model::FindAttribute(texture.attributes, "height")->numbers == sample::Numbers{32});
  CHECK(thing.object().materials.at(0).texture == 0);
}

TEST_CASE("a picture is a PNG file that exists") {
  const TemporaryFolder folder;
  folder.Write("wood.png", "\x89PNG\r\n\x1a\n and so on");
  folder.Write("wood.jpg", "JPEG");
  const auto with = [&folder](const std::string& file) {
    return Assembling("materials: {m: {texture: {file: " + file + "}}}\n" + kPaintedBall, 1, 0,
                      folder.path());
  };
  const Assembling good = with("wood.png");
  CHECK(good.object().textures.at(0).files.at(0).output_file == "wood.png");
  CHECK(good.object().textures.at(0).files.at(0).file == folder.path() / "wood.png");
  CHECK(with("wood.jpg").findings() ==
        std::vector<std::string>{"3:33 texture of material 'm': 'wood.jpg' is not a PNG file"});
  CHECK(with("none.png").findings() ==
        std::vector<std::string>{"3:33 texture of material 'm': no file 'none.png' (file names are "
                                 "relative to the folder of the file that uses them)"});
}

}  // namespace
}  // namespace mjforge::assemble
