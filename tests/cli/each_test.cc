// Tests of `mjforge generate --each`: each object of a scene as a file of its own.

#include <catch2/catch.hpp>

#include "harness/command.h"

namespace mjforge {
namespace {

using Files = std::vector<std::string>;

class EachTest : public harness::ProgramTest {
 protected:
  EachTest() {
    folder().Write("scene.yaml",
                   "mjforge: 1\n"
                   "name: scene\n"
                   "joints: none\n"
                   "params: {width: 2cm .. 3cm}\n"
                   "materials: {oak: {texture: {builtin: checker}}}\n"
                   "regions: [{name: surface, size: [50cm, 50cm], pos: [0, 0, 1cm]}]\n"
                   "parts: [{name: board, type: box, size: [50cm, 50cm, 1cm], material: oak}]\n"
                   "bodies:\n"
                   "  - name: crate\n"
                   "    joints: free\n"
                   "    parts: [{name: floor, type: box, size: [4cm, 4cm, 1cm]}]\n"
                   "    place: {at: surface, uv: [0.5, 0.5], yaw: 0}\n"
                   "  - name: lid\n"
                   "    parent: crate\n"
                   "    pos: [0, 0, 2cm]\n"
                   "    joints: [{name: crate_hinge, type: hinge, axis: [0, 0, 1], start: 30deg}]\n"
                   "    parts: [{name: top, type: box, size: [4cm, 4cm, 5mm]}]\n"
                   "  - {name: peg, place: {at: surface, uv: [0, -0.5], yaw: 90deg},\n"
                   "     parts: [{name: body, type: lathe, profile: [[1cm, 0], [width, 0], [width, "
                   "1cm]]}]}\n");
  }
  harness::CommandResult Each(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"generate", "scene.yaml", "--each", "-q", "-s", "7"});
    return Run(std::move(arguments));
  }
  void Generate(std::vector<std::string> arguments) const {
    const auto result = Each(std::move(arguments));
    INFO(result.err);
    REQUIRE(result.status == 0);
  }
  // Returns the files of the test without the spec.
  Files Written() const {
    Files files = folder().Files();
    std::erase(files, "scene.yaml");
    return files;
  }
};

TEST_CASE_METHOD(EachTest, "placement.json has the file and the pose of each object") {
  Generate({"--target", "robosuite", "-o", "out"});
  CHECK(Written() == Files{"out/manifest.jsonl", "out/manifest.seal.json",
                           "out/scene_000000/crate.xml", "out/scene_000000/peg.xml",
                           "out/scene_000000/placement.json", "out/scene_000000/scene.xml"});
  const std::string text = folder().Read("out/scene_000000/placement.json");
  CHECK(text.starts_with(R"({"mjforge":")"));
  CHECK(text.find(R"("seed":7,"index":0,"target":"robosuite","objects":{)") != text.npos);
  CHECK(text.substr(text.find('\n') + 1) ==
        R"("scene":{"file":"scene.xml","pos":[0,0,0],"quat":[1,0,0,0],"free":false},
"crate":{"file":"crate.xml","pos":[0.2300000005,0.2300000005,0.02005],"quat":[1,0,0,0],"at":"surface","free":true,)"
        R"("joints":{"hinge":0.5235987756}},
"peg":{"file":"peg.xml","pos":[0,-0.23837739,0.0099998],"quat":[0.7071067812,0,0,0.7071067812],)"
        R"("at":"surface","free":false}
}}
)");
  const std::string crate = folder().Read("out/scene_000000/crate.xml");
  CHECK(crate.find(" part=crate target=robosuite -->") != crate.npos);
  CHECK(crate.find(R"(<joint name="hinge" type="hinge")") != crate.npos);
  CHECK(crate.find(R"( ref="0.5235987756")") != crate.npos);  // begins at its start
  const std::string manifest = folder().Read("out/manifest.jsonl");
  CHECK(manifest.starts_with(R"({"file":"scene_000000/placement.json",)"));
  CHECK(manifest.find(R"("each":true)") != manifest.npos);
}

TEST_CASE_METHOD(EachTest, "for robocasa each object has a folder with all that it needs") {
  Generate({"--target", "robocasa", "--assets", "files", "-o", "out"});
  Files files = Written();
  // Without hashes.
  for (std::string& file : files) {
    if (file.find("/assets/") != file.npos) file.resize(file.rfind('_'));
  }
  CHECK(files == Files{"out/manifest.jsonl", "out/manifest.seal.json",
                       "out/scene_000000/crate/model.xml", "out/scene_000000/peg/assets/body_0",
                       "out/scene_000000/peg/assets/body", "out/scene_000000/peg/model.xml",
                       "out/scene_000000/placement.json", "out/scene_000000/scene/assets/checker",
                       "out/scene_000000/scene/model.xml"});
  CHECK(Run({"validate", "out/scene_000000/peg/model.xml"}).status == 0);
}

TEST_CASE_METHOD(EachTest,
                 "objects do not depend on the number of processes, and can be replayed") {
  Generate({"-n", "4", "-j", "1", "-o", "one"});
  Generate({"-n", "4", "-j", "2", "-o", "two"});
  CHECK(folder().Read("one/manifest.jsonl") == folder().Read("two/manifest.jsonl"));
  CHECK(folder().Read("one/scene_000003/peg.xml") == folder().Read("two/scene_000003/peg.xml"));
  CHECK(folder().Read("one/scene_000003/peg.xml") != folder().Read("one/scene_000002/peg.xml"));
  CHECK(Run({"replay", "one/manifest.jsonl:3"}).status == 0);
  CHECK(Run({"replay", "one/scene_000003/peg.xml"}).status == 0);
  folder().Write("one/scene_000003/peg.xml",
                 folder().Read("one/scene_000003/peg.xml") + "<!-- changed -->");
  CHECK(Run({"replay", "one/scene_000003/peg.xml"}).status == 1);
}

TEST_CASE_METHOD(EachTest,
                 "a batch misses a changed object, makes it again, and may be made anew") {
  Generate({"-n", "3", "-o", "out"});
  CHECK(Run({"verify", "out"}).status == 0);
  const std::string peg = folder().Read("out/scene_000001/peg.xml");
  folder().Write("out/scene_000001/peg.xml", peg.substr(0, 300));
  CHECK(Run({"verify", "out"}).status == 1);
  Generate({"-n", "3", "-o", "out", "--resume"});
  CHECK(folder().Read("out/scene_000001/peg.xml") == peg);
  CHECK(Run({"verify", "out"}).status == 0);
  Generate({"-n", "3", "-o", "out", "--place-seed", "1"});
  CHECK(Run({"verify", "out"}).status == 0);
  folder().Write("out/scene_000001/peg.xml", "<mujoco/>");
  CHECK(Each({"-n", "3", "-o", "out"}).status == 3);
}

TEST_CASE_METHOD(EachTest, "a variant that is made again has no objects of earlier runs") {
  Generate({"-n", "2", "-o", "out"});
  std::string spec = folder().Read("scene.yaml");
  spec.resize(spec.find("  - {name: peg"));
  folder().Write("scene.yaml", spec);
  folder().Write("out/scene_000000/notes.txt", "mine");
  Generate({"-n", "1", "-o", "out"});
  CHECK(Written() == Files{"out/manifest.jsonl", "out/manifest.seal.json",
                           "out/scene_000000/crate.xml", "out/scene_000000/notes.txt",
                           "out/scene_000000/placement.json", "out/scene_000000/scene.xml",
                           "out/scene_000001/crate.xml", "out/scene_000001/peg.xml",
                           "out/scene_000001/placement.json", "out/scene_000001/scene.xml"});
}

TEST_CASE_METHOD(EachTest, "an archive has a folder for each variant") {
  Generate({"-n", "3", "--assets", "files", "-j", "1", "-o", "x.tar"});
  Generate({"-n", "3", "--assets", "files", "-j", "2", "-o", "y.tar"});
  CHECK(folder().Read("x.tar") == folder().Read("y.tar"));
  const std::string tar = folder().Read("x.tar");
  for (const char* member : {"scene_000002/placement.json", "scene_000002/crate.xml",
                             "scene_000002/assets/checker_", "scene_000002.json"}) {
    CHECK(tar.find(member) != tar.npos);
  }
  CHECK(Run({"verify", "x.tar"}).status == 0);
  CHECK(Run({"replay", "x.manifest.jsonl:2"}).status == 0);
  Generate({"-n", "3", "--assets", "files", "-o", "x.tar", "--place-seed", "1"});  // is its own
  for (const char* shard : {"0/2", "1/2"})
    Generate({"-n", "4", "--target", "robosuite", "-o", "parts", "--shard", shard});
  CHECK(Run({"merge", "parts"}).status == 0);
  CHECK(Run({"verify", "parts"}).status == 0);
}

TEST_CASE_METHOD(EachTest,
                 "the option --each needs several files, a target without a floor, and a scene") {
  const auto message = [&](std::vector<std::string> arguments) {
    const auto result = Each(std::move(arguments));
    CHECK(result.status != 0);
    return result.err.substr(0, result.err.find('\n'));
  };
  CHECK(message({"-o", "x.xml"}) ==
        "mjforge: error: --each writes several files: -o x.xml must be a folder or an archive");
  CHECK(message({"-o", "-"}) ==
        "mjforge: error: --each writes several files: -o - must be a folder or an archive");
  CHECK(message({"--target", "scene"}) ==
        "mjforge: error: --each: files for --target scene have a floor of their own; the targets "
        "are mujoco, robosuite, robocasa, mjx");
  folder().Write("scene.yaml",
                 "mjforge: 1\nname: ball\nparts: [{name: a, type: sphere, size: 1cm}]\n");
  CHECK(message({}) ==
        "scene.yaml:3:9: error: 'ball' is one object, not a scene of several (seed 7, index 0) "
        "[target/one-object]");
  CHECK(Written().empty());
}

}  // namespace
}  // namespace mjforge
