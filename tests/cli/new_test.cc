// Tests of `mjforge new`.

#include <catch2/catch.hpp>

#include "crate.h"
#include "harness/quick_settings.h"

namespace mjforge {
namespace {

TEST_CASE_METHOD(CrateTest, "a new spec is commented, and has no finding") {
  const auto made = Run({"new", "desk-lamp.yaml"});
  CHECK(made.status == 0);
  CHECK(made.err ==
        "mjforge: note: wrote desk-lamp.yaml; `mjforge preview desk-lamp.yaml` draws it\n");
  const std::string text = harness::ReadFile(folder() / "desk-lamp.yaml");
  CHECK(text.starts_with("# "));
  CHECK(text.find("\nname: lamp\n") != std::string::npos);
  const auto checked = Run({"check", "desk-lamp.yaml", "-n", "50", "--physics", "-q"});
  CHECK(checked.status == 0);
  CHECK(checked.err.empty());
  const auto tall = Run({"check", "desk-lamp.yaml", "--physics", "--set", "height=3"});
  CHECK(tall.status == 1);
  CHECK(tall.err.find("'lamp' topples") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "a copy of any bundled spec works where it is") {
  std::vector<std::string> check = {"check", "-n", "1", "-q"};
  int count = 0;
  const std::string list = Run({"catalogue"}).out;
  for (std::size_t at = list.find('\n') + 1; at < list.size(); at = list.find('\n', at) + 1) {
    const std::string name = list.substr(at, list.find(' ', at) - at);
    const std::string file = "copy_" + std::to_string(count++) + ".yaml";
    INFO(name);
    CHECK(Run({"new", file, "--like", name, "-q"}).status == 0);
    if (!name.starts_with("scenes/")) {  // each takes as long as ten objects
      check.push_back(file);
      continue;
    }
    std::vector<std::string> alone = harness::QuickOptions(name);
    alone.insert(alone.begin(), {"check", "-n", "1", "-q", file});
    const auto checked = Run(alone);
    CHECK(checked.status == 0);
    CHECK(checked.err.empty());
  }
  CHECK(count > 50);
  const auto checked = Run(check);
  CHECK(checked.status == 0);
  CHECK(checked.err.empty());
}

TEST_CASE_METHOD(CrateTest, "the references of a copy lead to the same files") {
  folder().Write("a/paint.yaml", "mjforge: 1\nmaterials: {paint: {rgba: [1, 0, 0, 1]}}\n");
  folder().Write("a/wall.yaml",
                 "# yaml-language-server: $schema=no/such.json\n#\n# A wall.\nmjforge: 1\n"
                 "name: wall\nimport: [paint.yaml]\nmaterials: {wall: {rgba: [0, 1, 0, 1]}}\n"
                 "params: {side: {choice: [wall, floor]}}\n"
                 "parts: [{name: \"${side}\", type: box, size: [1, 1, 1], material: wall}]\n"
                 "bodies:\n  - {name: brick, spec: 'stones/brick', pos: [3, 0, 0]}\n"
                 "  - {name: other, mjcf: other.xml, pos: [6, 0, 0]}\n"
                 "contact: {exclude: [[wall, brick]]}\n");
  folder().Write("a/stones/brick.yaml",
                 "mjforge: 1\nname: brick\nparts: [{name: b, type: box, size: [1, 1, 1]}]\n");
  folder().Write(
      "a/other.xml",
      "<mujoco><worldbody><body name='o'><geom size='1'/></body></worldbody></mujoco>\n");
  std::filesystem::create_directory(folder() / "b");
  const auto made = Run({"new", "b/fence.yaml", "--like", "a/wall.yaml"});
  CHECK(made.status == 0);
  CHECK(harness::ReadFile(folder() / "b/fence.yaml") ==
        "# A wall.\nmjforge: 1\n"
        "name: wall\nimport: [../a/paint.yaml]\nmaterials: {wall: {rgba: [0, 1, 0, 1]}}\n"
        "params: {side: {choice: [wall, floor]}}\n"
        "parts: [{name: \"${side}\", type: box, size: [1, 1, 1], material: wall}]\n"
        "bodies:\n  - {name: brick, spec: ../a/stones/brick.yaml, pos: [3, 0, 0]}\n"
        "  - {name: other, mjcf: ../a/other.xml, pos: [6, 0, 0]}\n"
        "contact: {exclude: [[wall, brick]]}\n");
  CHECK(Run({"check", "b/fence.yaml", "-n", "3", "-q"}).err.empty());

  // A path that is no plain text is put in quotation marks.
  folder().Write(
      "c, d/it's.xml",
      "<mujoco><worldbody><body name='o'><geom size='1'/></body></worldbody></mujoco>\n");
  folder().Write("c, d/post.yaml",
                 "mjforge: 1\nname: post\nbodies: [{name: o, mjcf: &file 'it''s.xml'}]\n");
  CHECK(Run({"new", "b/post.yaml", "--like", "c, d/post.yaml"}).status == 0);
  CHECK(harness::ReadFile(folder() / "b/post.yaml") ==
        "mjforge: 1\nname: post\nbodies: [{name: o, mjcf: &file '../c, d/it''s.xml'}]\n");
  CHECK(Run({"check", "b/post.yaml", "-n", "1", "-q"}).err.empty());

  // A name in the search path stays one.
  const std::map<std::string, std::string> path = {{"MJFORGE_PATH", (folder() / "a").string()}};
  CHECK(Run({"new", "b/rail.yaml", "--like", "wall"}, {}, path).status == 0);
  const std::string text = harness::ReadFile(folder() / "b/rail.yaml");
  CHECK(text.find("import: [paint.yaml]") != std::string::npos);
  CHECK(text.find("spec: 'stones/brick'") != std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "new replaces no file, and says what is wrong") {
  folder().Write("mine.yaml", "mine\n");
  const auto exists = Run({"new", "mine.yaml"});
  CHECK(exists.status == 3);
  CHECK(exists.err ==
        "mjforge: error: 'mine.yaml' exists [output/exists]\n"
        "  hint: choose another name, or replace the file with --force\n");
  CHECK(harness::ReadFile(folder() / "mine.yaml") == "mine\n");
  CHECK(Run({"new", "mine.yaml", "--force"}).status == 0);
  CHECK(harness::ReadFile(folder() / "mine.yaml") != "mine\n");

  CHECK(Run({"new", "my lamp.yaml"}).err ==
        "mjforge: note: wrote my lamp.yaml; `mjforge preview 'my lamp.yaml'` draws it\n");

  CHECK(Run({"new", "lamp"}).err ==
        "mjforge: error: the name of a spec ends with .yaml, as in 'lamp.yaml'\n"
        "  hint: see 'mjforge new --help'\n");
  const auto unknown = Run({"new", "a.yaml", "--like", "tools/hamer"});
  CHECK(unknown.status == 3);
  CHECK(unknown.err ==
        "mjforge: error: cannot find the spec 'tools/hamer' [yaml/cannot-read]\n"
        "  hint: did you mean 'tools/hammer'?\n");
  CHECK(!std::filesystem::exists(folder() / "a.yaml"));
}

}  // namespace
}  // namespace mjforge
