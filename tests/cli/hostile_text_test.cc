// Tests that texts of other people's files cannot control a terminal.

#include <catch2/catch.hpp>

#include "crate.h"

namespace mjforge {
namespace {

// Clears the screen and sets the title; then CSI as one character (C1), a change of the writing
// direction, and DEL.
const std::string kHostile = "x\x1b[2J\x1b]0;t\a\xc2\x9b\xe2\x80\xae\x7f";

class HostileTextTest : public CrateTest {
 protected:
  HostileTextTest() {
    folder().Write("evil.yaml",
                   R"(mjforge: 1
name: evil
description: "x\e[2J\e]0;t\a\x9b\u202e\x7f"
params:
  a: {value: 1 .. 2, doc: "x\e[2J\e]0;t\a\x9b\u202e\x7f"}
  word: {value: {choice: ["'x\e[2J\e]0;t\a\x9b\u202e\x7f'"]}}
parts: [{name: p, type: box, size: [a, 1, 1]}]
)");
    const std::string name = "x&#27;[2J&#27;]0;t&#7;&#155;&#8238;&#127;";
    folder().Write("evil.xml", "<mujoco model=\"" + name + "\"><worldbody><body name=\"" + name +
                                   "\"><geom name=\"" + name + "\" size=\"1\"/><joint name=\"" +
                                   name + "\" type=\"slide\"/><camera name=\"" + name +
                                   "\"/><site name=\"" + name + "\"/><body name=\"b" + name +
                                   "\" pos=\"1 0 0\"><joint name=\"b" + name +
                                   "\" limited=\"true\" range=\"0 90\"/><geom name=\"b" + name +
                                   "\" size=\"1\"/></body></body></worldbody></mujoco>");
    folder().Write("wrong.xml", "<mujoco><worldbody><geom material=\"" + name +
                                    "\" size=\"1\"/></worldbody></mujoco>");
  }

  /// Runs the program, and checks that standard output and standard error contain no ASCII control
  /// characters except line ends and tabs, and neither U+009B (CSI) nor U+202E (a bidirectional
  /// control).
  harness::CommandResult RunSafely(std::vector<std::string> arguments,
                                   std::map<std::string, std::string> environment = {}) const {
    CAPTURE(arguments);
    auto result = Run(std::move(arguments), {}, std::move(environment));
    for (const std::string& text : {result.out, result.err}) {
      INFO(text);
      std::string controls;
      for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f) controls += c;
      }
      CHECK(controls.empty());
      CHECK(text.find("\xc2\x9b") == std::string::npos);
      CHECK(text.find("\xe2\x80\xae") == std::string::npos);
    }
    return result;
  }
};

TEST_CASE_METHOD(HostileTextTest, "texts of a spec are shown with escapes") {
  const auto shown = RunSafely({"inspect", "evil.yaml"});
  CHECK(shown.status == 0);
  CHECK(shown.out.starts_with("evil: x\\x1b[2J\\x1b]0;t\\x07\\u009b\\u202e\\x7f\n\n"));
  RunSafely({"generate", "evil.yaml", "-n", "2", "-o", "out", "-v"});
  CHECK(RunSafely({"inspect", "out"}).out.find("word") != std::string::npos);
  RunSafely({"inspect", "evil.yaml", "--json"});
  RunSafely({"inspect", "out", "--json"});
  RunSafely({"check", "evil.yaml", "-n", "2"});
  RunSafely({"report", "out"});
  RunSafely({"replay", "out/manifest.jsonl:0"});
  RunSafely({"verify", "out"});
  RunSafely({"__complete", "generate", "evil.yaml", "--set", ""});
  RunSafely({"__complete", "generate", "evil.yaml", "--set", "word="});
}

TEST_CASE_METHOD(HostileTextTest, "a folder of specs is listed with escapes") {
  std::filesystem::create_directory(folder() / "p");
  std::filesystem::copy(folder() / "evil.yaml", folder() / "p/evil.yaml");
  std::filesystem::copy(folder() / "evil.yaml", folder().path() / "p" / (kHostile + ".yaml"));
  const std::map<std::string, std::string> path = {{"MJFORGE_PATH", (folder() / "p").string()}};
  const auto list = RunSafely({"catalogue"}, path);
  CHECK(list.status == 0);
  CHECK(list.out.find("x\\x1b[2J") != std::string::npos);
  RunSafely({"__complete", "generate", ""}, path);
}

TEST_CASE_METHOD(HostileTextTest, "a text of several lines is one line of a table") {
  std::filesystem::create_directory(folder() / "p");
  folder().Write(
      "p/two.yaml",
      "mjforge: 1\nname: two\ndescription: |\n  One.\n  Two.\nparams:\n"
      "  r: {value: 1, doc: \"a\\nb\\tc\\n\"}\nparts: [{name: a, type: sphere, size: r}]\n");
  const auto list = RunSafely({"catalogue"}, {{"MJFORGE_PATH", (folder() / "p").string()}});
  CHECK(list.out.find("One. Two.\n") != std::string::npos);
  const auto shown = RunSafely({"inspect", "p/two.yaml"});
  CHECK(shown.out.starts_with("two: One. Two.\n\n"));
  CHECK(shown.out.find("a b c\n") != std::string::npos);
}

TEST_CASE_METHOD(HostileTextTest, "names of an MJCF file are shown with escapes") {
  const auto shown = RunSafely({"inspect", "evil.xml", "--sweep"});
  CHECK(shown.status == 0);
  CHECK(shown.out.starts_with("x\\x1b[2J\\x1b]0;t\\x07\\u009b\\u202e\\x7f\n\n"));
  RunSafely({"validate", "evil.xml", "wrong.xml"});
  RunSafely({"validate", "evil.xml", "--physics"});
  RunSafely({"validate", "evil.xml", "wrong.xml", "--json"});
  RunSafely({"inspect", "evil.xml", "--json"});
  RunSafely({"inspect", "wrong.xml"});
  RunSafely({"inspect", "wrong.xml", "--findings", "json"});
  RunSafely({"preview", "evil.xml", "-o", "x.png"});
  RunSafely({"preview", "evil.xml", "--joint", "none=1", "-o", "x.png"});
  RunSafely({"view", "wrong.xml"});
  RunSafely({"__complete", "preview", "evil.xml", "--joint", ""});
  for (const char* file : {"evil.xml", "wrong.xml"}) {
    folder().Write("attach.yaml",
                   "mjforge: 1\nname: at\nbodies: [{name: b, mjcf: " + std::string(file) + "}]\n");
    RunSafely({"check", "attach.yaml", "-n", "1"});
    RunSafely({"inspect", "attach.yaml", "--sweep"});
  }
}

TEST_CASE_METHOD(HostileTextTest, "names of files and words of the command line are escaped") {
  for (const char* file : {"evil.yaml", "evil.xml", "wrong.xml"}) {
    const std::string ending = std::string(file).substr(std::string(file).find('.'));
    std::filesystem::copy(folder() / file, folder().path() / (kHostile + file + ending));
    for (const char* command : {"check", "inspect", "validate", "preview", "view", "generate"})
      RunSafely({command, kHostile + file + ending});
  }
  const std::string out = kHostile + "out";
  REQUIRE(RunSafely({"generate", "crate.yaml", "-n", "2", "-o", out}).status == 0);
  REQUIRE(RunSafely({"generate", "crate.yaml", "-n", "2", "-o", kHostile + ".tar"}).status == 0);
  for (const char* command : {"inspect", "report", "merge", "verify"}) {
    RunSafely({command, out});
    RunSafely({command, out + "/manifest.jsonl"});
    RunSafely({command, kHostile + ".tar"});
  }
  for (const char* what : {"/manifest.jsonl:1", "/crate_000000.xml", "/none.xml"})
    RunSafely({"replay", out + what});
  RunSafely({kHostile});
  for (const char* command : {"generate", "inspect", "report", "catalogue", "schema", "help"}) {
    RunSafely({command, "--" + kHostile});
    RunSafely({command, kHostile});
  }
  RunSafely({"inspect", "crate.yaml", "--contains", kHostile});
  RunSafely({"inspect", "crate.yaml", "--set", kHostile + "=1"});
  RunSafely({"inspect", "crate.yaml", "--set", "height=" + kHostile});
}

TEST_CASE_METHOD(HostileTextTest, "texts of a manifest are shown with escapes") {
  REQUIRE(Run({"generate", "crate.yaml", "-n", "2", "-q", "-o", "out"}).status == 0);
  std::string text = folder().Read("out/manifest.jsonl");
  const std::string escaped = R"(x\u001b[2J\u009b\u202e)";
  for (const std::string was : {"\"crate.yaml\"", "\"height\"", "\"crate\"", "\"mujoco\""}) {
    for (std::size_t at = 0; (at = text.find(was, at)) != std::string::npos; at += escaped.size())
      text.replace(at, was.size(), "\"" + escaped + "\"");
  }
  folder().Write("out/manifest.jsonl", text);
  CHECK(RunSafely({"inspect", "out"}).out.starts_with("batch of x\\x1b[2J"));
  RunSafely({"report", "out"});
  RunSafely({"verify", "out"});
  RunSafely({"replay", "out/manifest.jsonl:0"});
  folder().Write("out/manifest.jsonl", kHostile + "\n");
  for (const char* command : {"inspect", "report", "verify"}) RunSafely({command, "out"});
}

}  // namespace
}  // namespace mjforge
