// Tests of placed bodies in generated files and records.

#include <catch2/catch.hpp>

#include "harness/command.h"

namespace mjforge {
namespace {

class PlacesTest : public harness::ProgramTest {
 protected:
  PlacesTest() { Write(""); }

  // Writes the spec of a table with boxes and mugs, and these further entries.
  void Write(const std::string& entries) const {
    folder().Write(
        "scene.yaml",
        "mjforge: 1\n"
        "name: scene\n"
        "joints: none\n"
        "bodies:\n"
        "  - {name: table, spec: furniture/round_table, params: {style: kitchen}}\n"
        "  - {name: box, joints: free, parts: [{name: box, type: box, size: [3cm, 2cm, 1cm]}],\n"
        "     place: {at: table.surface}}\n"
        "  - {name: \"mug_${i}\", for: {i: 3}, spec: containers/mug, joints: free,\n"
        "     place: {at: table.surface, clear: 1cm}}\n" +
            entries);
  }
  void Generate(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"generate", "scene.yaml", "-q", "-n", "4", "-s", "7"});
    const auto result = Run(std::move(arguments));
    INFO(result.err);
    REQUIRE(result.status == 0);
  }
  std::string Object(const std::string& out) const {
    return folder().Read(out + "/scene_000002.xml");
  }
  // Returns the line of a text that contains the word; empty if none does.
  static std::string LineWith(const std::string& text, const std::string& word) {
    const std::size_t at = text.find(word);
    if (at == std::string::npos) return {};
    const std::size_t begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
  }
};

TEST_CASE_METHOD(PlacesTest, "places do not depend on the number of processes") {
  Generate({"-o", "one", "-j", "1"});
  Generate({"-o", "two", "-j", "2"});
  CHECK(folder().Read("one/manifest.jsonl") == folder().Read("two/manifest.jsonl"));
  CHECK(Object("one") == Object("two"));
}

TEST_CASE_METHOD(PlacesTest, "a body at the end of the spec moves none before it") {
  Generate({"-o", "before"});
  Write("  - {name: bowl, spec: containers/bowl, joints: free, place: {at: table.surface}}\n");
  Generate({"-o", "after"});
  for (const char* name : {"scene_box", "scene_mug_0", "scene_mug_1", "scene_mug_2"}) {
    const std::string body = "<body name=\"" + std::string(name) + "\"";
    CHECK_FALSE(LineWith(Object("before"), body).empty());
    CHECK(LineWith(Object("before"), body) == LineWith(Object("after"), body));
  }
}

TEST_CASE_METHOD(PlacesTest, "another place seed moves the same objects, and replay follows") {
  Generate({"-o", "out"});
  Generate({"--place-seed", "3", "-o", "moved"});
  Generate({"--place-seed", "3", "-o", "again"});
  CHECK(Object("moved") == Object("again"));
  const std::string body = "<body name=\"scene_mug_1\"";
  CHECK(LineWith(Object("out"), body) != LineWith(Object("moved"), body));
  const std::string mesh = "<mesh name=\"scene_mug_1_look\"";
  CHECK_FALSE(LineWith(Object("out"), mesh).empty());
  CHECK(LineWith(Object("out"), mesh) == LineWith(Object("moved"), mesh));
  CHECK(Run({"replay", "moved/manifest.jsonl:2"}).err ==
        "moved/manifest.jsonl:2: regenerated, same bytes\n");
  CHECK(Run({"replay", "moved/scene_000002.xml"}).status == 0);
}

TEST_CASE_METHOD(PlacesTest, "the record says where each body stands and which were left out") {
  Write(
      "  - {name: \"slab_${i}\", for: {i: 2}, fewer: true, place: {at: table.surface},\n"
      "     parts: [{name: \"slab_${i}\", type: box, size: [2m, 2m, 1cm]}]}\n");
  Generate({"-o", "out"});
  const std::string manifest = folder().Read("out/manifest.jsonl");
  CHECK(manifest.find(R"("places":[{"body":"scene_box","at":"table.surface","pos":[)") !=
        std::string::npos);
  CHECK(manifest.find(R"("left_out":["scene_slab_0","scene_slab_1"])") != std::string::npos);
  CHECK(Run({"replay", "out/manifest.jsonl:2"}).status == 0);
}

TEST_CASE_METHOD(PlacesTest, "a pile has the same bytes in every process, and can be replayed") {
  folder().Write(
      "scene.yaml",
      "mjforge: 1\n"
      "name: scene\n"
      "joints: none\n"
      "params: {wide: 2cm .. 3cm}\n"
      "regions: [{name: inside, size: [8cm, 8cm], pos: [0, 0, 1cm], walls: true}]\n"
      "parts:\n"
      "  - {name: floor, type: box, size: [10cm, 10cm, 1cm]}\n"
      "  - {name: \"wall_${i}\", for: {i: 4}, type: box, size: [10cm, 1cm, 8cm],\n"
      "     pos: [9cm * cos(90deg * i), 9cm * sin(90deg * i), 9cm],\n"
      "     euler: [0, 0, 90deg * (i + 1)]}\n"
      "bodies:\n"
      "  - {name: \"block_${i}\", for: {i: 5}, joints: free, place: {at: inside, pile: {}},\n"
      "     parts: [{name: \"block_${i}\", type: box, size: [wide, 2cm, 15mm]}]}\n");
  // Some piles tremble for longer than they may.
  Generate({"-o", "one", "-j", "1", "--on-invalid", "resample"});
  Generate({"-o", "two", "-j", "2", "--on-invalid", "resample"});
  CHECK(folder().Read("one/manifest.jsonl") == folder().Read("two/manifest.jsonl"));
  CHECK(Object("one") == Object("two"));
  CHECK_FALSE(LineWith(Object("one"), "<option cone=\"elliptic\" impratio=\"10\"").empty());
  CHECK(folder().Read("one/manifest.jsonl").find("\"pile_mujoco\":\"") != std::string::npos);
  CHECK(Run({"replay", "one/manifest.jsonl:2"}).status == 0);
  Generate({"--place-seed", "1", "-o", "other", "--on-invalid", "resample"});
  CHECK(Object("other") != Object("one"));
}

}  // namespace
}  // namespace mjforge
