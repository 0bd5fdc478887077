// Tests of --assets files: meshes as OBJ and textures as PNG beside the object.

#include <catch2/catch.hpp>

#include "harness/command.h"
#include "harness/png.h"

namespace mjforge {
namespace {

using Files = std::vector<std::string>;

// Fixture with a vase that has a varying mesh, a constant mesh and a pattern.
class VaseTest : public harness::ProgramTest {
 protected:
  VaseTest() {
    folder().Write("vase.yaml",
                   "mjforge: 1\n"
                   "name: vase\n"
                   "params: {height: 0.1 .. 0.2}\n"
                   "materials: {clay: {texture: {type: 2d, builtin: checker, width: 4}}}\n"
                   "parts:\n"
                   "  - {name: body, type: hull, density: 500, material: clay,\n"
                   "     points: [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, height]]}\n"
                   "  - {name: foot, type: hull, density: 500, pos: [0, 0, -0.1],\n"
                   "     points: [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]}\n");
  }

  harness::CommandResult Generate(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"generate", "vase.yaml", "--seed", "1",
                                          "--assets", "files",     "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Run(arguments);
  }
  // Returns the names of the files in a folder that have this ending.
  Files Named(const std::string& start, const std::string& ending) const {
    Files found;
    for (const std::string& file : folder().Files()) {
      if (file.starts_with(start) && file.ends_with(ending)) found.push_back(file);
    }
    return found;
  }
};

TEST_CASE_METHOD(VaseTest, "meshes and textures are files, each content once in a batch") {
  REQUIRE(Generate({"-n", "3", "-o", "out/"}).status == 0);
  CHECK(Named("out/assets/body_", ".obj").size() == 3);
  REQUIRE(Named("out/assets/foot_", ".obj").size() == 1);
  REQUIRE(Named("out/assets/checker_", ".png").size() == 1);
  CHECK(Named("out/assets/", "").size() == 5);
  CHECK(folder().Read(Named("out/assets/foot_", ".obj")[0]).starts_with("v "));
  const harness::Png png = harness::DecodePng(folder().Read(Named("out/assets/", ".png")[0]));
  CHECK(png.width == 4);
  CHECK(png.At(0, 0) != png.At(3, 0));
  const std::string xml = folder().Read("out/vase_000000.xml");
  CHECK(xml.find(" assets=files -->") != std::string::npos);
  CHECK(xml.find("vertex=") == std::string::npos);
  CHECK(xml.find("builtin=") == std::string::npos);
  CHECK(Run({"validate", "out/vase_000000.xml", "out/vase_000002.xml", "-q"}).status == 0);
  CHECK(Run({"verify", "out/", "-q"}).status == 0);
}

TEST_CASE_METHOD(VaseTest, "objects without meshes and patterns have no folder of files") {
  folder().Write("box.yaml",
                 "mjforge: 1\nname: box\n"
                 "parts: [{name: b, type: box, size: [0.1, 0.1, 0.1], density: 500}]\n");
  REQUIRE(Run({"generate", "box.yaml", "--assets", "files", "-q", "-o", "x.xml"}).status == 0);
  CHECK(folder().Files() == Files{"box.yaml", "vase.yaml", "x.xml"});
}

TEST_CASE_METHOD(VaseTest, "the bytes do not depend on workers and order") {
  REQUIRE(Generate({"-n", "20", "-j", "1", "-o", "one/"}).status == 0);
  REQUIRE(Generate({"-n", "20", "-j", "3", "-o", "other/"}).status == 0);
  for (const std::string& file : Named("one/", "")) {
    INFO(file);
    CHECK(folder().Read(file) == folder().Read("other/" + file.substr(4)));
  }
  CHECK(Named("one/", "").size() == Named("other/", "").size());
  REQUIRE(Generate({"--first", "7", "-o", "seven.xml"}).status == 0);
  CHECK(folder().Read("seven.xml") == folder().Read("one/vase_000007.xml"));
  CHECK(Named("assets/", ".obj").size() == 2);
}

TEST_CASE_METHOD(VaseTest, "archives hold the files before the objects that need them") {
  for (const std::string ending : {".tar", ".tar.zst"}) {
    const std::string name =
        ending == ".tar" ? "plain" : "packed";  // each batch has its own manifest
    REQUIRE(Generate({"-n", "3", "-o", name + ending}).status == 0);
    const auto unpacked =
        harness::Command{.program = "/bin/sh",
                         .arguments = {"-c", "mkdir u && tar -C u -xvf ./" + name + ending},
                         .environment = {},
                         .folder = folder().path()}
            .Run();
    REQUIRE(unpacked.status == 0);
    CHECK(unpacked.out.starts_with("assets/checker_"));
    CHECK(std::ranges::count(unpacked.out, '\n') == 11);  // 3 objects, 3 records, 5 files
    CHECK(Run({"validate", "u/vase_000000.xml", "u/vase_000001.xml", "u/vase_000002.xml", "-q"})
              .status == 0);
    CHECK(Run({"verify", name + ending, "-q"}).status == 0);
    const std::string manifest = name + ".manifest.jsonl" + (ending == ".tar" ? "" : ".zst");
    CHECK(Run({"replay", manifest + ":2", "-q"}).status == 0);
    std::filesystem::remove_all(folder() / "u");
  }
}

TEST_CASE_METHOD(VaseTest, "shards have the bytes of the whole batch") {
  REQUIRE(Generate({"-n", "8", "-o", "whole/"}).status == 0);
  REQUIRE(Generate({"-n", "8", "--shard", "0/2", "-o", "parts/"}).status == 0);
  REQUIRE(Generate({"-n", "8", "--shard", "1/2", "-o", "parts/"}).status == 0);
  REQUIRE(Run({"merge", "parts/", "-q"}).status == 0);
  REQUIRE(Run({"verify", "parts/", "-q"}).status == 0);
  for (const std::string& file : Named("whole/", "")) {
    if (file.find("seal") != std::string::npos) continue;
    INFO(file);
    CHECK(folder().Read(file) == folder().Read("parts/" + file.substr(6)));
  }
}

TEST_CASE_METHOD(VaseTest, "a file that is gone or changed is found, and made again by --resume") {
  REQUIRE(Generate({"-n", "3", "-o", "out/"}).status == 0);
  const std::string foot = Named("out/assets/foot_", ".obj")[0];
  const std::string bytes = folder().Read(foot);
  std::filesystem::remove(folder() / foot);
  CHECK(Run({"verify", "out/", "-q"}).status == 1);
  CHECK(Generate({"-n", "3", "-o", "out/", "--resume"}).status == 0);
  CHECK(folder().Read(foot) == bytes);
  // A power cut can leave such a file.
  folder().Write(foot, bytes.substr(0, 20) + std::string(10, '\0'));
  CHECK(Run({"verify", "out/", "-q"}).status == 1);
  CHECK(Generate({"-n", "3", "-o", "out/", "--resume"}).status == 0);
  CHECK(folder().Read(foot) == bytes);
}

TEST_CASE_METHOD(VaseTest, "a batch with files is another one than a batch without") {
  REQUIRE(Run({"generate", "vase.yaml", "--seed", "1", "-n", "3", "-o", "out/", "-q"}).status == 0);
  const auto result = Generate({"-n", "5", "-o", "out/", "--resume"});
  CHECK(result.status == 3);
  CHECK(result.err.find("assets_as is unset") != std::string::npos);
}

TEST_CASE_METHOD(VaseTest, "somebody else's file of that name is not replaced") {
  REQUIRE(Generate({"-o", "x.xml"}).status == 0);
  const std::string foot = Named("assets/foot_", ".obj")[0];
  const std::string bytes = folder().Read(foot);
  folder().Write(foot, "mine\n");
  const auto result = Generate({"-o", "x.xml"});
  CHECK(result.status == 3);
  CHECK(result.err == "mjforge: error: '" + foot +
                          "' exists, and its content differs from what belongs there (seed 1, "
                          "index 0) [output/exists]\n"
                          "  hint: choose another place, or overwrite it with --force\n");
  CHECK(folder().Read(foot) == "mine\n");
  CHECK(Generate({"-o", "x.xml", "--force"}).status == 0);
  CHECK(folder().Read(foot) == bytes);
}

TEST_CASE_METHOD(VaseTest, "where files cannot be written, no object is") {
  folder().Write("out/assets", "a file\n");
  const auto result = Generate({"-n", "2", "-o", "out/"});
  CHECK(result.status == 3);
  CHECK(result.err.find("cannot make folder 'out/assets'") != std::string::npos);
  CHECK(Named("out/vase_", "").empty());
}

TEST_CASE_METHOD(VaseTest, "standard output cannot carry them") {
  const auto result = Generate({"-o", "-"});
  CHECK(result.status == 2);
  CHECK(
      result.err.starts_with("mjforge: error: --assets files: standard output cannot carry them; "
                             "write to a file, a folder or an archive"));
}

TEST_CASE_METHOD(VaseTest, "they are no inputs of a Make rule") {
  REQUIRE(Generate({"-o", "x.xml", "-MD", "-MF", "x.d"}).status == 0);
  CHECK(folder().Read("x.d") == "x.xml: \\\n  vase.yaml\n");
}

TEST_CASE_METHOD(VaseTest, "an object with files is regenerated from its comment") {
  REQUIRE(Generate({"-o", "x.xml"}).status == 0);
  CHECK(Run({"replay", "x.xml"}).err == "x.xml: regenerated, same bytes\n");
  std::string text = folder().Read("x.xml");
  folder().Write("x.xml", text.replace(text.find("assets=files"), 12, "assets=boxes"));
  CHECK(
      Run({"replay", "x.xml"})
          .err.find("'x.xml' was made with assets as 'boxes', which this version does not know") !=
      std::string::npos);
}

}  // namespace
}  // namespace mjforge
