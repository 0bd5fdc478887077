#include <catch2/catch.hpp>

#include <filesystem>

#include "harness/temporary_folder.h"
#include "loading.h"

namespace {

namespace fs = std::filesystem;

using Folder = mjforge::harness::TemporaryFolder;

Loaded LoadFile(const std::string& reference, std::vector<fs::path> search_path = {}) {
  Loaded loaded;
  mjforge::spec::LoadOptions options;
  options.search_path = std::move(search_path);
  loaded.spec = mjforge::spec::LoadSpec(reference, options, loaded.sources, loaded.findings);
  return loaded;
}

const std::string kBall = "mjforge: 1\nname: ball\nparts:\n  - {name: a, type: sphere, size: 1}\n";

}  // namespace

TEST_CASE("a spec is found by path, by catalogue name and by last name", "[loader]") {
  const Folder folder;
  const fs::path file = folder.Write("toys/ball.yaml", kBall);
  CHECK(LoadFile(file.string()).spec != nullptr);
  CHECK(LoadFile("toys/ball", {folder.path()}).spec != nullptr);
  CHECK(LoadFile("ball", {folder.path()}).spec != nullptr);
  CHECK(LoadFile("bal", {folder.path()}).Report() ==
        Strings{"0:0 yaml/cannot-read: cannot find the spec 'bal' (did you mean 'ball'?)"});
  CHECK(mjforge::spec::ListSpecs(folder.path()) == Strings{"toys/ball"});
}

TEST_CASE("a name without a folder means a scene or robosuite's object last", "[loader]") {
  const Folder folder;
  for (const char* name : {"robosuite/hammer", "scenes/desk", "tools/hammer", "zoo/desk"})
    folder.Write(std::string(name) + ".yaml", kBall);
  const auto found = [&](const std::string& name) {
    return LoadFile(name, {folder.path()}).spec->folder.filename().string();
  };
  CHECK(found("hammer") == "tools");
  CHECK(found("desk") == "zoo");
  fs::remove(folder / "tools/hammer.yaml");
  CHECK(found("hammer") == "robosuite");
}

TEST_CASE("what cannot be read is reported", "[loader]") {
  const Folder folder;
  CHECK(LoadFile(folder.path().string()).Report() ==
        Strings{"0:0 yaml/cannot-read: cannot read '" + folder.path().string() +
                "': it is a folder"});
  CHECK(LoadFile("/dev/null").Report() ==
        Strings{"0:0 yaml/cannot-read: cannot read '/dev/null': it is a device"});
}

TEST_CASE("imports bring materials and defaults; the spec's own win", "[loader]") {
  const Folder folder;
  folder.Write("shared.yaml",
               "mjforge: 1\nmaterials: {wood: {density: 1}, steel: {density: 2}}\n"
               "defaults: {part: {friction: 2, condim: 4}}\n");
  const fs::path file =
      folder.Write("a.yaml", kBall +
                                 "import: [shared]\nmaterials: {wood: {density: 9}}\n"
                                 "defaults: {part: {friction: 1}}\n");
  const Loaded loaded = LoadFile(file.string());
  REQUIRE(loaded.Report() == Strings{});
  REQUIRE(loaded.spec->materials.size() == 2);
  CHECK(loaded.spec->materials[0].name == "wood");
  CHECK(std::get<double>(loaded.spec->materials[0].fields[0].value.form) == 9);
  REQUIRE(loaded.spec->defaults.part.size() == 2);
  CHECK(std::get<double>(loaded.spec->defaults.part[0].value.form) == 1);
  CHECK(loaded.spec->files.size() == 2);
}

TEST_CASE("the hash of a spec alone is its text's SHA-256", "[loader]") {
  // Of `printf 'mjforge: 1\nname: ball\nparts:\n  - {name: a, type: sphere, size: 1}\n' |
  // sha256sum`.
  const Loaded loaded = Load(kBall);
  REQUIRE(loaded.spec != nullptr);
  CHECK(loaded.spec->sha256 == "b5ad1da8e2bba1d76c697897c65b51cefbbb015aa212964f24de805b51145b4c");
}

TEST_CASE("a spec that refers to itself prints the chain", "[loader]") {
  const Folder folder;
  const fs::path self = folder.Write("self.yaml", kBall + "import: self.yaml\n");
  CHECK(LoadFile(self.string()).Report() ==
        Strings{"5:9 spec/import-cycle: file refers to itself: self.yaml -> self.yaml"});
  const fs::path a =
      folder.Write("a.yaml", "mjforge: 1\nname: a\nparts:\n  - {name: b, spec: b}\n");
  folder.Write("b.yaml", "mjforge: 1\nname: b\nparts:\n  - {name: a, spec: a}\n");
  CHECK(LoadFile(a.string()).Report() ==
        Strings{"4:21 spec/import-cycle: file refers to itself: a.yaml -> b.yaml -> a.yaml"});
}

TEST_CASE("a welded spec takes parameters of its own kind", "[loader]") {
  const Folder folder;
  folder.Write("ball.yaml",
               "mjforge: 1\nname: ball\nparams: {radius: 1}\nparts:\n"
               "  - {name: a, type: sphere, size: radius}\n");
  const auto report = [&](const std::string& params) {
    return LoadFile(folder
                        .Write("a.yaml",
                               "mjforge: 1\nname: a\nparts:\n  - {name: b, spec: ball, "
                               "params: {" +
                                   params + "}}\n")
                        .string())
        .Report();
  };
  CHECK(report("radius: 1 .. 2") == Strings{});
  CHECK(
      report("radus: 1") ==
      Strings{
          "4:36 spec/unknown-parameter: 'ball' has no parameter 'radus' (did you mean 'radius'?)"});
  CHECK(
      report("radius: box") ==
      Strings{"4:44 spec/wrong-type: parameter 'radius' of 'ball' is a number, but this is text"});
}

TEST_CASE("a spec that is not found names the nearest one", "[loader]") {
  const Folder folder;
  folder.Write("ball.yaml", kBall);
  const fs::path file =
      folder.Write("own/a.yaml", "mjforge: 1\nname: a\nparts:\n  - {name: b, spec: bals}\n");
  CHECK(LoadFile(file.string(), {folder.path()}).Report() ==
        Strings{"4:21 spec/not-found: cannot find 'bals' (did you mean 'ball'?)"});
}

TEST_CASE("a file of another version or shape is refused", "[loader]") {
  CHECK(Load("mjforge: 2\nname: t\nparts: []\n").Report() ==
        Strings{"1:10 spec/version: format version '2' is not known; this program reads 1"});
  CHECK(Load("[1, 2]\n").Report() == Strings{"1:1 spec/wrong-type: a spec must be a mapping of "
                                             "keys, got a list (start with `mjforge: 1` "
                                             "and a `name:`)"});
  CHECK(Load("nam: t\n").Report() ==
        Strings{"1:1 spec/unknown-key: unknown key 'nam' in an object (did you mean 'name'?)",
                "1:1 spec/missing-key: no format version (begin the file with `mjforge: 1`)",
                "1:1 spec/missing-key: spec without 'parts' or 'bodies'"});
}

TEST_CASE("a misspelt section is one finding", "[loader]") {
  const std::string parts =
      "parts: [{name: a, type: cylinder, size: [r, h], pos: [r, r, r + h], axisangle: [1, 0, 0, r "
      "/ r]}]\n";
  const std::string head = "mjforge: 1\nname: b\n";
  CHECK(Load(head + "parms: {r: 1cm, h: 2cm}\n" + parts).Report() ==
        Strings{"3:1 spec/unknown-key: unknown key 'parms' in an object (did you mean 'params'?)"});
  CHECK(Load(head + "params: {r: {chioce: [1cm, 2cm]}, h: 2cm}\n" + parts).Report() ==
        Strings{"3:14 spec/unknown-key: unknown key 'chioce' in a distribution (did you mean "
                "'choice'?)"});
  CHECK(Load(head + "parts: [{for: {i: 2}, lets: {h: 1cm}, name: 'a_${i}', type: sphere, size: h}]")
            .Report() ==
        Strings{"3:23 spec/unknown-key: unknown key 'lets' in a part (did you mean 'let'?)"});
  CHECK(Load(head + "params: {h: 2cm}\n" + parts).Report() ==
        Strings{"4:42 expr/unknown-name: unknown name 'r', and at 4 other places"});
}

TEST_CASE("a key of another element is said to be one", "[loader]") {
  CHECK(Load("mjforge: 1\nname: b\nparts: [{name: a, type: sphere, size: 1cm, joints: []}]\n")
            .Report() ==
        Strings{"3:44 spec/unknown-key: unknown key 'joints' in a part ('joints' is "
                "a key of a body)"});
}

TEST_CASE("a draw anywhere makes the spec one of random variants", "[loader]") {
  const Folder folder;
  folder.Write("inner.yaml",
               "mjforge: 1\nname: inner\nparts:\n  - {name: a, type: sphere, size: 1 .. 2}\n");
  folder.Write("shared.yaml", "mjforge: 1\nparams: {w: 1 .. 2}\n");
  const auto is_random = [&](const std::string& text) {
    const Loaded loaded = LoadFile(folder.Write("outer.yaml", text).string());
    return loaded.spec != nullptr && loaded.spec->draws.random;
  };
  const std::string head = "mjforge: 1\nname: outer\n";
  CHECK_FALSE(is_random(kBall));
  CHECK_FALSE(is_random(kBall + "mass: {cycle: [1, 2]}\n"));
  CHECK_FALSE(is_random(kBall + "materials: {paint: {rgba: {hsv: [0.5, 1, 1]}}}\n"));
  CHECK(is_random(kBall + "materials: {paint: {rgba: {hsv: [0 .. 1, 1, 1]}}}\n"));
  CHECK(is_random(kBall + "params: {m: {normal: [1, 0.1]}}\n"));
  CHECK_FALSE(Load(kBall + "params: {m: {normal: [1, 0.1]}}\n", {{"m", "1"}}).spec->draws.random);
  CHECK(is_random(kBall + "params: {l: {shuffle: [1, 2, 3]}}\n"));
  CHECK(is_random(kBall + "sites:\n  - {name: s, quat: random}\n"));
  CHECK(is_random(kBall + "sites:\n  - {name: s, pos: {on_sphere: 1}}\n"));
  CHECK(is_random(kBall + "import: shared.yaml\n"));
  CHECK(is_random(head + "parts:\n  - {name: p, spec: inner.yaml}\n"));
}

TEST_CASE("an exact choice anywhere makes the spec one of whole batches", "[loader]") {
  const Folder folder;
  const std::string exact = "{choice: [1, 2], exact: true}";
  folder.Write("inner.yaml", "mjforge: 1\nname: inner\nparams: {r: " + exact +
                                 "}\nparts:\n  - {name: a, type: sphere, size: r}\n");
  folder.Write("shared.yaml", "mjforge: 1\nmaterials: {wood: {density: " + exact + "}}\n");
  const auto is_exact = [&](const std::string& text) {
    const Loaded loaded = LoadFile(folder.Write("outer.yaml", text).string());
    CHECK(loaded.Report() == Strings{});
    return loaded.spec != nullptr && loaded.spec->draws.exact;
  };
  const std::string head = "mjforge: 1\nname: outer\n";
  CHECK_FALSE(is_exact(kBall));
  CHECK(is_exact(kBall + "params: {r: " + exact + "}\n"));
  CHECK(is_exact(kBall + "mass: " + exact + "\n"));
  CHECK(is_exact(kBall + "import: shared.yaml\n"));
  CHECK(is_exact(head + "parts:\n  - {name: p, spec: inner.yaml}\n"));
  CHECK(is_exact(head + "bodies:\n  - {name: b, spec: inner.yaml}\n"));
}
