// The example project of docs/make.md, built by GNU make.

#include <catch2/catch.hpp>

#include "make/cases.h"
#include "make/project.h"

namespace mjforge::make {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

bool IsUpToDate(const Project& project, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return project.Run("make", arguments).status == 0;
}

TEST_CASE("what was made is not made again") {
  Project project;
  project.Do("make", {"-j2"});
  Names all = kTrays;
  all.insert(kDrawers.begin(), kDrawers.end());
  CHECK(project.Fresh("build/") == all);
  CHECK(IsUpToDate(project));
  project.Age();
  CHECK(project.Do("make", {"-j2"}) == "make: Nothing to be done for 'all'.\n");
  CHECK(project.Fresh("build/").empty());
}

TEST_CASE("a touched file makes again exactly what was made from it") {
  Project project;
  project.Do("make", {"-j2"});
  for (const Dependents& expected : kDependents) {
    INFO(expected.file);
    project.Touch(expected.file);
    project.Do("make", {"-j2"});
    CHECK(project.Fresh("build/") == expected.targets);
    CHECK(IsUpToDate(project));
  }
}

TEST_CASE("a spec with a mistake leaves no target and no rule") {
  Project project;
  const std::string good = project.folder().Read("specs/tray.yaml");
  project.Change("specs/tray.yaml", "type: box", "type: bx");
  const harness::CommandResult failed = project.Run("make", {"-j2", "-k"});
  CHECK(failed.status == 2);
  CHECK(failed.err.find("specs/tray.yaml:14:26: error:") != std::string::npos);
  CHECK(project.folder().Files().size() > 10);  // the drawers
  for (const std::string& name : project.folder().Files()) {
    INFO(name);
    CHECK_FALSE(name.starts_with("build/tray"));
    CHECK_FALSE(name.starts_with("build/rack"));
  }
  project.folder().Write("specs/tray.yaml", good);
  project.Age();
  project.Do("make", {"-j2"});
  CHECK(project.Fresh("build/") == kTrays);
  CHECK(IsUpToDate(project));
}

TEST_CASE("a mistake in what was good leaves it to be made again") {
  Project project;
  project.Do("make", {"-j2"});
  const std::string before = project.folder().Read("build/drawer.xml");
  project.Change("parts/steel.xml", "density=\"7850\"", "density=\"7850");
  CHECK(project.Run("make", {"-k"}).status == 2);
  CHECK(project.Fresh("build/").empty());
  CHECK_FALSE(IsUpToDate(project));
  project.Change("parts/steel.xml", "density=\"7850", "density=\"7800\"");
  project.Do("make", {});
  CHECK(project.Fresh("build/") == kDrawers);
  CHECK(project.folder().Read("build/drawer.xml") != before);
}

TEST_CASE("a batch with failed variants is not made") {
  Project project;
  const std::string manifest = "build/trays/manifest.jsonl";
  // Most variants are too narrow for it, which shows only when they are made.
  const auto break_spec = [&] {
    project.Change("specs/tray.yaml", "width / 2, 4mm]", "width / 2 - 9cm, 4mm]");
  };
  const auto mend_spec = [&] {
    project.Change("specs/tray.yaml", "width / 2 - 9cm, 4mm]", "width / 2, 4mm]");
  };
  break_spec();
  CHECK(project.Run("make", {manifest}).status == 2);
  CHECK_FALSE(fs::exists(project.folder() / manifest));
  CHECK_FALSE(fs::exists(project.folder() / "build/trays/manifest.d"));
  mend_spec();
  project.Do("make", {manifest});
  CHECK(project.Fresh("build/") == Names{"trays/manifest.jsonl"});
  break_spec();
  CHECK(project.Run("make", {manifest}).status == 2);
  CHECK(project.Fresh("build/").empty());
  CHECK_FALSE(IsUpToDate(project, {manifest}));
  mend_spec();
  project.Do("make", {manifest});
  CHECK(project.Fresh("build/") == Names{"trays/manifest.jsonl"});
}

TEST_CASE("a changed mesh gets a copy") {
  Project project;
  project.Do("make", {"-j2"});
  project.Change("parts/grip.obj", "v 1 0 0", "v 1.1 0 0");
  project.Do("make", {"-j2"});
  CHECK(project.Fresh("build/") == kDrawers);
  const std::string changed = project.folder().Read("parts/grip.obj");
  const std::vector<std::string> files = project.folder().Files();
  CHECK(std::ranges::count_if(files, [&](const std::string& file) {
          return file.starts_with("build/assets/grip_") && project.folder().Read(file) == changed;
        }) == 1);
}

TEST_CASE("an imported file that is no longer imported may go") {
  Project project;
  project.folder().Write("colours.yaml", "mjforge: 1\nmaterials: {red: {rgba: [1, 0, 0, 1]}}\n");
  project.Change("specs/tray.yaml", "import: ../materials.yaml",
                 "import: [../materials.yaml, ../colours.yaml]");
  project.Do("make", {"-j2"});
  project.Change("specs/tray.yaml", "[../materials.yaml, ../colours.yaml]", "../materials.yaml");
  fs::remove(project.folder() / "colours.yaml");
  project.Do("make", {"-j2"});
  CHECK(project.Fresh("build/") == kTrays);
  CHECK(IsUpToDate(project));
}

TEST_CASE("an imported file that a rule makes is made first") {
  Project project;
  fs::rename(project.folder() / "materials.yaml", project.folder() / "materials.in");
  project.folder().Write("more.mk", "include Makefile\nmaterials.yaml: materials.in\n\tcp $< $@\n");
  project.Do("make", {"materials.yaml", "-f", "more.mk"});
  project.Do("make", {"-f", "more.mk"});
  CHECK(IsUpToDate(project, {"-f", "more.mk"}));
  project.Touch("materials.in");
  project.Do("make", {"-f", "more.mk"});
  CHECK(project.Fresh("build/") == kTrays);
  CHECK(IsUpToDate(project, {"-f", "more.mk"}));
}

TEST_CASE("files are named from here, or by their whole path as the spec is") {
  const Project project;
  const std::string here = fs::canonical(project.folder().path()).string() + "/";
  const auto rule = [&](const std::string& folder) {
    project.Do(harness::MjforgeProgram(),
               {"generate", folder + "specs/drawer.yaml", "-q", "-MD", "-o", "x.xml"});
    fs::remove_all(project.folder() / "assets");
    return project.folder().Read("x.d");
  };
  const auto expected = [](const std::string& folder) {
    std::string text = "x.xml:";
    for (const std::string name :
         {"parts/grip.obj", "parts/handle.xml", "parts/steel.xml", "specs/drawer.yaml"}) {
      text.append(" \\\n  ").append(folder).append(name);
    }
    return text + "\n";
  };
  CHECK(rule("") == expected(""));
  CHECK(rule(here) == expected(here));
}

TEST_CASE("rules name files with blanks, # and $") {
  Project project;
  const harness::TemporaryFolder& folder = project.folder();
  folder.Write("my own/tray #1 $x.yaml", folder.Read("specs/tray.yaml"));
  project.Change("my own/tray #1 $x.yaml", "../materials.yaml", "'good $wood #2.yaml'");
  fs::rename(folder / "materials.yaml", folder / "my own/good $wood #2.yaml");
  folder.Write("odd.mk",
               "out/a\\ tray\\ \\#1\\ $$x.xml: my\\ own/tray\\ \\#1\\ $$x.yaml\n"
               "\tmjforge generate '$<' -q -MD -MP -MF out/odd.d -o '$@'\n"
               "-include out/odd.d\n");
  const std::string target = "out/a tray #1 $x.xml";
  for (const std::string name : {"", "my own/tray #1 $x.yaml", "my own/good $wood #2.yaml"}) {
    INFO(name);
    if (!name.empty()) project.Touch(name);
    project.Do("make", {"-f", "odd.mk"});
    CHECK(project.Fresh("out/") == Names{"a tray #1 $x.xml"});
    CHECK(IsUpToDate(project, {"-f", "odd.mk"}));
    project.Age();
    project.Do("make", {"-f", "odd.mk"});
    CHECK(project.Fresh("out/").empty());
  }
}

TEST_CASE("with a stamp a change that leaves an object as it is stops there") {
  Project project;
  const std::vector<std::string> arguments = {"-f", "unchanged.mk"};
  project.Do("make", arguments);
  CHECK(project.Fresh("out/").contains("tray.txt"));
  project.Age();
  project.Do("make", arguments);
  CHECK(project.Fresh("out/").empty());
  // Its time is new, its text the same.
  project.Touch("materials.yaml");
  CHECK(project.Do("make", arguments).find("generate specs/tray.yaml") != std::string::npos);
  CHECK(project.Fresh("out/").empty());
  CHECK(project.Do("make", arguments).find("mjforge") == std::string::npos);
  project.Change("materials.yaml", "density: 710", "density: 720");
  project.Do("make", arguments);
  CHECK(project.Fresh("out/") == Names{"rack.txt", "rack.xml", "tray.txt", "tray.xml"});
  CHECK(project.Do("make", arguments).find("mjforge") == std::string::npos);
}

}  // namespace
}  // namespace mjforge::make
