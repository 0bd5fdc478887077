#include "mjforge/attach/asset_reader.h"

#include <string>

#include <catch2/catch.hpp>

#include "attaching.h"

namespace mjforge::attach {
namespace {

const std::string kAssets =
    "<default><material specular=\"0.3\"/></default>\n<asset>\n"
    "<texture name=\"checks\" type=\"2d\" builtin=\"checker\" rgb1=\".1 0.2 0.3\" width=\"8\" "
    "height=\"8\" hflip=\"true\"/>\n"
    "<texture name=\"other\" builtin=\"flat\" width=\"8\" height=\"8\"/>\n"
    "<material name=\"tiled\" texture=\"checks\" texrepeat=\"3 4\" texuniform=\"true\" "
    "rgba=\"0.1 0.2 0.3 1\"/>\n"
    "<material name=\"plain\" specular=\"0.5\"/>\n<material name=\"other\" texture=\"other\"/>\n"
    "</asset>\n";

TEST_CASE("materials and textures that are used are taken, once each, with their numbers") {
  Attaching files(
      Mjcf("<body name=\"b\"><geom name=\"g\" size=\"1\" material=\"tiled\"/>"
           "<geom name=\"h\" size=\"1\" material=\"plain\"/>"
           "<site name=\"s\" material=\"tiled\"/></body>\n"
           "<body name=\"c\"><geom size=\"1\" material=\"other\"/></body>\n",
           kAssets));
  const model::Attachment& b = files.Get();
  REQUIRE(Names(b.materials) == "tiled plain");
  REQUIRE(Names(b.textures) == "checks");
  CHECK(b.materials[0].texture == 0);
  CHECK(b.materials[1].texture == -1);
  CHECK(Said(b.materials[0].attributes) ==
        "rgba=0.1 0.2 0.3 1 specular=0.3 texrepeat=3 4 texuniform=true");
  CHECK(b.materials[1].attributes.empty());
  CHECK(Said(b.textures[0].attributes) ==
        "type=2d builtin=checker hflip=true rgb1=0.1 0.2 0.3 width=8 height=8");
  CHECK(b.textures[0].files.empty());
  CHECK(b.textures[0].mark.line == 4);
  CHECK(b.bodies[0].parts[0].material == 0);
  CHECK(b.bodies[0].parts[1].material == 1);
  CHECK(b.bodies[0].sites[0].material == 0);
  CHECK(files.Get("c").materials[0].name == "other");
}

TEST_CASE("texture files are absolute, one for each side that has one") {
  // A PNG of 1 x 1 pixels.
  const std::string pixel(
      "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000"
      "\001\000\000\000\001\010\002\000\000\000\220\167\123\336\000\000\000\014\111"
      "\104\101\124\170\234\143\140\140\140\000\000\000\004\000\001\366\027\070\125"
      "\000\000\000\000\111\105\116\104\256\102\140\202",
      69);
  Attaching files(Mjcf(
      "<body name=\"b\"><geom size=\"1\" material=\"a\"/><geom size=\"1\" material=\"c\"/>"
      "</body>\n",
      "<compiler texturedir=\"pictures\"/><asset>"
      "<texture name=\"one\" type=\"2d\" file=\"one.png\"/>"
      "<texture name=\"six\" type=\"cube\" fileright=\"right.png\" fileup=\"up.png\"/>"
      "<material name=\"a\" texture=\"one\"/><material name=\"c\" texture=\"six\"/></asset>\n"));
  for (const char* name : {"one", "right", "up"}) {
    files.Write("pictures/" + std::string(name) + ".png", pixel);
  }
  const model::Attachment& b = files.Get();
  REQUIRE(b.textures.size() == 2);
  REQUIRE(b.textures[0].files.size() == 1);
  CHECK(b.textures[0].files[0].attribute == "file");
  CHECK(b.textures[0].files[0].file.is_absolute());
  CHECK(b.textures[0].files[0].file.filename() == "one.png");
  REQUIRE(b.textures[1].files.size() == 2);
  CHECK(b.textures[1].files[0].attribute == "fileright");
  CHECK(b.textures[1].files[1].file.filename() == "up.png");
}

}  // namespace
}  // namespace mjforge::attach
