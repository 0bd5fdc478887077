// Tests of `mjforge view`.

#include <catch2/catch.hpp>
#include <filesystem>

#include "crate.h"

namespace mjforge {
namespace {

// Fixture with a script in place of the viewer; it prints its arguments and its folder.
class ViewTest : public CrateTest {
 protected:
  ViewTest() {
    std::filesystem::create_directory(folder() / "tmp");
    Viewer("cp \"$1\" seen.xml && echo \"$1\" && pwd && ls && cp seen.xml \"$OUT/seen.xml\"\n");
  }

  void Viewer(const std::string& script) const {
    const auto file = folder().Write("bin/mujoco-simulate", "#!/bin/sh\n" + script);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }

  harness::CommandResult View(std::vector<std::string> arguments,
                              const std::string& display = ":0") const {
    arguments.insert(arguments.begin(), "view");
    return Run(arguments, {},
               {{"PATH", (folder() / "bin").string() + ":/usr/bin:/bin"},
                {"TMPDIR", (folder() / "tmp").string()},
                {"OUT", folder().path().string()},
                {"DISPLAY", display},
                {"WAYLAND_DISPLAY", ""}});
  }

  bool Clean() const { return std::filesystem::is_empty(folder() / "tmp"); }
};

TEST_CASE_METHOD(ViewTest, "view shows the scene of a variant, and nothing is left of it") {
  const auto result = View({"crate.yaml", "--index", "3", "--seed", "5"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  CHECK(result.out.starts_with((folder() / "tmp").string() + "/mjforge-"));
  CHECK(Clean());
  const auto expected = Run({"generate", "crate.yaml", "--first", "3", "--seed", "5", "--target",
                             "scene", "-o", "-", "-q"});
  REQUIRE(expected.status == 0);
  CHECK(folder().Read("seen.xml") == expected.out);
  CHECK(Run({"validate", "seen.xml"}).status == 0);
}

TEST_CASE_METHOD(ViewTest, "view shows a file where it is") {
  folder().Write("ball.xml", "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>");
  const auto result = View({"ball.xml"});
  CHECK(result.status == 0);
  CHECK(result.out.starts_with((folder() / "ball.xml").string() + "\n"));
  CHECK(Clean());
  CHECK(folder().Read("seen.xml") == folder().Read("ball.xml"));
}

TEST_CASE_METHOD(ViewTest, "what was written for a later MuJoCo is shown as this one reads it") {
  std::filesystem::create_directory(folder() / "meshes");
  folder().Write("meshes/roof.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  folder().Write(
      "house.xml",
      "<mujoco><compiler meshdir='meshes'/>"
      "<asset><mesh name='roof' file='roof.obj'/><material name='m' metallic='1'/></asset>"
      "<worldbody><geom name='g' type='mesh' mesh='roof'/></worldbody></mujoco>");
  const auto result = View({"house.xml"});
  CHECK(result.status == 0);
  CHECK(Clean());
  // The file's meshes are found from any folder.
  const auto expected = Run({"inspect", "house.xml", "--json", "--quiet"});
  CHECK(Run({"inspect", "seen.xml", "--json", "--quiet"}).out == expected.out);
  if (Run({"--version"}).out.find("\nMuJoCo 2.") == std::string::npos) return;
  CHECK(result.out.find((folder() / "tmp").string() + "/mjforge-") == 0);
  CHECK(result.out.find("\nhouse.xml\n") != std::string::npos);
  CHECK(result.err.find("warning: 'metallic' of material 'm' is left out") != std::string::npos);
  CHECK(folder().Read("seen.xml").find("<geom name=\"g\" ") != std::string::npos);
}

TEST_CASE_METHOD(ViewTest, "assets go with the scene") {
  folder().Write("parts/roof.obj",
                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  folder().Write("roof.yaml",
                 "mjforge: 1\nname: roof\n"
                 "parts: [{name: a, type: mesh, file: parts/roof.obj, density: 100}]\n");
  const auto result = View({"roof.yaml"});
  CHECK(result.status == 0);
  CHECK(result.out.find("\nassets\n") != std::string::npos);
  CHECK(Clean());
}

TEST_CASE_METHOD(ViewTest, "a viewer that fails is a finding") {
  Viewer("exit 3\n");
  const auto failed = View({"crate.yaml"});
  CHECK(failed.status == 1);
  CHECK(failed.err ==
        "mjforge: error: MuJoCo's viewer 'mujoco-simulate' failed: exit status 3 "
        "[picture/no-viewer]\n");
  Viewer("kill -SEGV $$\n");
  CHECK(View({"crate.yaml"}).err.find("failed: signal 11 killed it") != std::string::npos);
  CHECK(Clean());
}

TEST_CASE_METHOD(ViewTest, "a signal goes on to the viewer, and nothing is left") {
  // The script sends the signal to the program that started it, and waits to be stopped.
  for (const char* signal : {"INT", "TERM"}) {
    INFO(signal);
    Viewer("trap 'echo stopped; exit 0' INT TERM\nkill -" + std::string(signal) +
           " $PPID\nwhile :; do :; done\n");
    const auto result = View({"crate.yaml"});
    CHECK(result.status == 130);
    CHECK(result.out == "stopped\n");
    CHECK(Clean());
  }
}

TEST_CASE_METHOD(ViewTest, "without a viewer or a display there is a finding") {
  const auto blind = View({"crate.yaml"}, "");
  CHECK(blind.status == 1);
  CHECK(blind.err ==
        "mjforge: error: there is no display for MuJoCo's viewer: neither DISPLAY nor "
        "WAYLAND_DISPLAY is set [picture/no-display]\n"
        "  hint: 'mjforge preview' draws without one\n");
  const auto none = Run({"view", "crate.yaml"}, {}, {{"PATH", "/nowhere"}});
  CHECK(none.status == 1);
  CHECK(none.err ==
        "mjforge: error: MuJoCo's viewer is not installed: there is no 'mujoco-simulate' in PATH "
        "[picture/no-viewer]\n"
        "  hint: install the package libmujoco-samples\n");
}

TEST_CASE_METHOD(ViewTest, "a bad spec is not shown") {
  folder().Write("bad.yaml", "mjforge: 1\nname: bad\nparts: [{name: a, type: bx, size: [1]}]\n");
  const auto result = View({"bad.yaml"});
  CHECK(result.status == 1);
  CHECK(result.out.empty());
  CHECK(result.err.starts_with("bad.yaml:3:"));
}

}  // namespace
}  // namespace mjforge
